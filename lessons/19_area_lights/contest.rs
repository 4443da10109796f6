//! The headline: a picture under each kind of light, all patterns and both measures, in time and error.

use super::pictures::stage;
use super::place::{MEASURES, method, mid, other};
use lightbench::color::Rgb;
use lightbench::film::Image;
use lightbench::film::metric::compare;
use lightbench::integrator::Local;
use lightbench::light::{AreaLight, Emission, Emitter, Light, Measure};
use lightbench::measure::{Method, Point, Series, Tally, timed};
use lightbench::render::{Picture, render};
use lightbench::sample::Pattern;
use lightbench::scene::Scene;
use lightbench_kit::figure::{Axis, Chart, Figure, Guide, Table, short};
use lightbench_kit::lesson::Result;

/// Shadow rays of the contestants' lights.
pub const BUDGETS: [u32; 4] = [4, 16, 64, 256];
/// Of the table.
pub const USUAL: u32 = 16;

/// The stage under one light.
pub fn lit(emitter: Emitter, n: u32, pattern: Pattern, measure: Measure) -> Result<Scene> {
    let mut scene = stage()?;
    let radiance = Rgb::splat(match emitter {
        Emitter::Sphere(_) => 9.0,
        _ => 14.0,
    });
    let light = AreaLight::new(emitter, Emission::diffuse(radiance)).sampled(n, pattern).by(measure);
    scene.lights = vec![Light::from(light)];
    Ok(scene)
}

pub struct Contest {
    /// Lines of the headline: by measure, by pattern.
    pub rectangle: Vec<Vec<Series>>,
    /// At 16 rays: by light, measure, pattern.
    pub usual: Vec<(&'static str, Vec<Vec<Point>>)>,
    pub picture: Picture,
    runs: u32,
}

fn measured(
    emitter: Emitter,
    budgets: &[u32],
    truth: &Image,
    picture: Picture,
    runs: u32,
) -> Result<Vec<Vec<Series>>> {
    let mut scenes = Vec::new();
    for (measure, _) in MEASURES {
        for pattern in Pattern::ALL {
            for &n in budgets {
                scenes.push((n, lit(emitter, n, pattern, measure)?, Tally::new(), 0.0));
            }
        }
    }
    let pixels = (picture.width * picture.height) as f64;
    // Every run takes all in turn, so that a busy moment of the machine favours none; short ones run more often.
    for run in 0..runs * 3 {
        let picture = Picture { seed: picture.seed.wrapping_add(run.into()), ..picture };
        for (_, scene, tally, rays) in scenes.iter_mut().filter(|s| run < runs || s.0 <= USUAL) {
            let (seconds, done) = timed(|| render(scene, &Local::default(), picture));
            tally.timed_answer(seconds, compare(&done.image, truth).rmse, 0.0);
            *rays = done.tally.total_rays() as f64 / pixels;
        }
    }
    let mut points = scenes.into_iter().map(|(n, _, tally, rays)| tally.rms_at(n.into()).worked(rays));
    let mut series = || Series::new(points.by_ref().take(budgets.len()).collect());
    Ok((0..2).map(|_| (0..5).map(|_| series()).collect()).collect())
}

impl Contest {
    /// On one thread, whose time other work on the machine disturbs least.
    pub fn measured(picture: Picture, truth_rays: u32, runs: u32) -> Result<Self> {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().map_err(other)?;
        pool.install(|| Self::on_this_thread(picture, truth_rays, runs))
    }

    fn on_this_thread(picture: Picture, truth_rays: u32, runs: u32) -> Result<Self> {
        let lamps = super::pictures::lamps()?;
        let (mut rectangle, mut usual) = (Vec::new(), Vec::new());
        for (k, (name, emitter)) in lamps.into_iter().enumerate() {
            let round = matches!(emitter, Emitter::Sphere(_));
            let measure = if round { Measure::SolidAngle } else { Measure::Area };
            let exact = lit(emitter, truth_rays, Pattern::Sobol, measure)?;
            let other_seed = Picture { seed: picture.seed ^ 0x7275_7468, ..picture };
            let truth = render(&exact, &Local::default(), other_seed).image;
            let budgets: &[u32] = if k == 0 { &BUDGETS } else { &[USUAL] };
            let found = measured(emitter, budgets, &truth, picture, runs)?;
            let at = |s: &Series| {
                s.points.iter().find(|p| p.parameter == f64::from(USUAL)).cloned().unwrap_or_default()
            };
            usual.push((name, found.iter().map(|by| by.iter().map(at).collect()).collect()));
            if k == 0 {
                rectangle = found;
            }
        }
        if rectangle.is_empty() {
            return Err(other("no light"));
        }
        Ok(Contest { rectangle, usual, picture, runs })
    }

    fn subtitle(&self) -> String {
        format!(
            "a sphere and a wall under a rectangular light, {} × {} pixels, {} runs and more; truth: Sobol’ points in thousands",
            self.picture.width, self.picture.height, self.runs
        )
    }

    /// Six of the ten, in time.
    pub fn headline(&self) -> Figure {
        let [area, solid] = [0, 1].map(|m| &self.rectangle[m]);
        let at = |s: &Series, k: usize| s.points.get(k).map_or(f64::NAN, mid);
        let title = format!(
            "By RMSE the fixed grid leads, but it errs in bands; of those that err as noise Sobol’s points err {:.1} times less than chance at 64 rays",
            at(&area[2], 2) / at(&area[3], 2)
        );
        let mut chart = Chart::speed_accuracy("error of radiance, RMSE [W m⁻² sr⁻¹]")
            .x(Axis::time("time per picture, one thread"))
            .title(&title)
            .subtitle(&self.subtitle());
        for (pattern, series) in Pattern::ALL.into_iter().zip(area).take(4) {
            chart = chart.line(method(pattern, Measure::Area), series);
        }
        chart = chart
            .line(Method::new("r2").styled(4), &area[4])
            .line(Method::new("sobol, solid angle").styled(5), &solid[3]);
        let seconds = |s: &Series, k: usize| s.points.get(k).and_then(|p| p.time).map_or(f64::NAN, |t| t.mid);
        let chart = chart
            .guide(Guide::slope_through(-0.5, seconds(&area[2], 1), 1.25 * at(&area[2], 1), "−½"))
            .guide(Guide::slope_through(-0.75, seconds(&area[3], 3), 0.8 * at(&area[3], 3), "−¾"));
        Figure::from(chart).caption(
            "Error of a picture against its time, 4, 16, 64 and 256 shadow rays from each place. The fixed grid is cheapest, since its points are the same everywhere; its errors are bands, which no \
             RMSE shows. Points by solid angle cost their arithmetic, and pay where the light is near or round.")
    }

    /// All ten over the counted rays.
    pub fn counted(&self) -> Figure {
        let [area, solid] = [0, 1].map(|m| &self.rectangle[m]);
        let worst = area.iter().chain(solid).filter_map(|s| s.points.last()).map(mid).fold(0.0, f64::max);
        let best = area.iter().chain(solid).filter_map(|s| s.points.last()).map(mid).fold(worst, f64::min);
        let mut chart = Chart::work_accuracy("rays a pixel", "error of radiance, RMSE [W m⁻² sr⁻¹]")
            .title(&format!(
                "At {} rays the best plan errs {:.0} times less than the worst",
                BUDGETS[3],
                worst / best
            ))
            .subtitle(&self.subtitle());
        for (series, measure) in [(area, Measure::Area), (solid, Measure::SolidAngle)] {
            for (k, pattern) in Pattern::ALL.iter().enumerate() {
                chart = chart.line(method(*pattern, measure).styled(k), &series[k]);
            }
        }
        Figure::from(chart).caption("The same over the number of rays, camera rays with them: all patterns by area and by solid angle.")
    }

    /// What a light should do unless told otherwise.
    pub fn table(&self) -> Table {
        let mut head = vec!["16 points".to_string()];
        head.extend(self.usual.iter().map(|(name, _)| format!("{name}: RMSE")));
        head.extend(self.usual.iter().map(|(name, _)| format!("{name} [ms]")));
        let mut table = Table::new(&head.iter().map(String::as_str).collect::<Vec<_>>()).timed();
        for (m, (measure, by)) in MEASURES.iter().enumerate() {
            for (p, pattern) in Pattern::ALL.iter().enumerate() {
                let point = |k: usize| &self.usual[k].1[m][p];
                let mut row = vec![format!("{}, {by}", pattern.name())];
                row.extend((0..3).map(|k| short(mid(point(k)))));
                let ms = |k: usize| point(k).time.map_or(f64::NAN, |t| 1.0e3 * t.mid);
                row.extend((0..3).map(|k| format!("{:.2}", ms(k))));
                table = table.row(&row.iter().map(String::as_str).collect::<Vec<_>>());
                if (*pattern, *measure) == (Pattern::Sobol, Measure::SolidAngle) {
                    table = table.marked();
                }
            }
        }
        let [rectangle, triangle, sphere] = [0, 1, 2].map(|k| self.by_solid_angle(k));
        table
            .title(&format!(
                "By solid angle 16 jittered points err {sphere:.0} times less on a sphere, {rectangle:.1} and {triangle:.1} times on rectangle and triangle"
            ))
            .subtitle(&format!(
                "one picture under each light, {} × {} pixels, one thread; marked is the default of spheres; flat lights take sobol by area",
                self.picture.width, self.picture.height
            ))
    }

    /// How many times less 16 jittered points err on a light by solid angle than by area.
    pub fn by_solid_angle(&self, light: usize) -> f64 {
        let error = |measure: usize| mid(&self.usual[light].1[measure][1]);
        error(0) / error(1)
    }

    /// How many times less 16 Sobol' points err than jittered ones on the rectangle, by area.
    pub fn by_sobol(&self) -> f64 {
        let error = |pattern: usize| mid(&self.usual[0].1[0][pattern]);
        error(1) / error(3)
    }
}
