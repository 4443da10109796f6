#!/usr/bin/env python3
"""Writes rows nastier than those of ray_torus.csv and quartic_roots.csv, at 150 digits and more (mpmath 1.3).

    nasty_roots.py ray_torus|quartic_roots SEED ROWS FILE

Inputs are exactly the f64 printed; columns, margins and condition numbers are those of the tables next to it.
ray_torus_nasty.csv and quartic_roots_nasty.csv are 600 and 500 rows drawn at random from seed 2 (3500 and 1500 rows).
"""
import csv, inspect, random, sys
import mpmath as mp
from mpmath import mpf
mp.mp.dps=150
R=random.Random(int(sys.argv[2])); N=int(sys.argv[3])
HAVE_INIT='roots_init' in inspect.signature(mp.polyroots).parameters
def roots(c, init=None):   # c highest first
    while c and c[0]==0: c=c[1:]
    if len(c)<2: return []
    for dps in (150,300,600):
        mp.mp.dps=dps
        try:
            kw={'roots_init':init} if (HAVE_INIT and init) else {}
            r=mp.polyroots(c,maxsteps=400,extraprec=dps*2,**kw); mp.mp.dps=150
            return r
        except mp.libmp.NoConvergence: pass
        finally: mp.mp.dps=150
    raise RuntimeError
def real_distinct(c,init=None):
    rs=roots(c,init); out=[]
    for r in rs:
        if abs(mp.im(r))<=mpf(10)**-45*abs(r): out.append(mp.re(r))
    out.sort()
    d=[]
    for r in out:
        if d and abs(r-d[-1])<=mpf(10)**-45*abs(r): continue
        d.append(r)
    return d
g=lambda x: repr(float(x)) if x is not None else ''
def U(a,b): return R.uniform(a,b)
def vec(): 
    while True:
        v=[R.gauss(0,1) for _ in range(3)]
        n=sum(x*x for x in v)**.5
        if n>1e-3: return [x/n for x in v]
def torus_row(cls,a,b,o,d):
    a,b=mpf(a),mpf(b); o=[mpf(x) for x in o]; d=[mpf(x) for x in d]
    D=sum(x*x for x in d); B=sum(x*y for x,y in zip(o,d)); M=sum(x*x for x in o); E=M+a*a-b*b
    A4=4*a*a
    c=[D*D,4*B*D,2*D*E+4*B*B-A4*(d[0]**2+d[1]**2),4*B*E-2*A4*(o[0]*d[0]+o[1]*d[1]),E*E-A4*(o[0]**2+o[1]**2)]
    # recentre for the solver
    tc=-B/D; S=a/mp.sqrt(D)
    # f(tc+S s)
    m=[o[i]+tc*d[i] for i in range(3)]; Mm=sum(x*x for x in m); Em=Mm+a*a-b*b; md=sum(x*y for x,y in zip(m,d))
    cc=[D*D*S**4,4*md*D*S**3,(2*D*Em+4*md*md-A4*(d[0]**2+d[1]**2))*S**2,(4*md*Em-2*A4*(m[0]*d[0]+m[1]*d[1]))*S,Em*Em-A4*(m[0]**2+m[1]**2)]
    ts=[tc+S*s for s in real_distinct(cc)]
    def parts(t):
        p=[o[i]+t*d[i] for i in range(3)]; G=sum(x*x for x in p)+a*a-b*b; rho2=p[0]**2+p[1]**2
        f=G*G-A4*rho2
        gr=[4*G*p[0]-2*A4*p[0],4*G*p[1]-2*A4*p[1],4*G*p[2]]
        w=sum(abs(o[i]*gr[i]) for i in range(3))+sum(abs(t*d[i]*gr[i]) for i in range(3))+abs(a*(4*G*a-8*a*rho2))+abs(b*4*G*b)
        return f,w,sum(x*y for x,y in zip(gr,d)),p,gr
    dc=[4*cc[0],3*cc[1],2*cc[2],cc[3]]
    crit=[tc+S*s for s in real_distinct(dc)]
    margin=min([abs(parts(t)[0])/parts(t)[1] for t in crit if t>0] or [mpf(1)])
    pos=[t for t in ts if t>0]
    row={'cls':cls,'a':g(a),'b':g(b)}
    for k,x in zip('xyz',o): row['o'+k]=g(x)
    for k,x in zip('xyz',d): row['d'+k]=g(x)
    row['n_real']=len(ts); row['n_pos']=len(pos); row['margin']=g(margin)
    for k in range(4): row[f't{k}']=row[f'cond{k}']=''
    for k,t in enumerate(pos):
        f,w,df,p,gr=parts(t); row[f't{k}']=g(t); row[f'cond{k}']=g(w/abs(t*df)) if df!=0 else 'inf'
    for k in 'xyz': row['n'+k]=''
    if pos:
        p=parts(pos[0])[3]; rho=mp.sqrt(p[0]**2+p[1]**2); h=[p[0]*(rho-a)/rho,p[1]*(rho-a)/rho,p[2]]; n=mp.sqrt(sum(x*x for x in h))
        for k,x in zip('xyz',h): row['n'+k]=g(x/n)
    return row
def surf(a,b,u,v):
    import math
    n=[math.cos(u)*math.cos(v),math.sin(u)*math.cos(v),math.sin(v)]
    return [ (a+b*math.cos(v))*math.cos(u),(a+b*math.cos(v))*math.sin(u),b*math.sin(v)],n
def gen_torus():
    import math
    cls=R.choice(['far','thin','fat','near_tangent','near_tangent','near_tangent_thin','near_tangent_far','parallel','equatorial','equatorial_tangent','on_surface','inside','hole','plane_contact','axis_tiny','random','villarceau','vertical_tangent'])
    a=10**U(-9,9) if R.random()<.5 else U(.5,3)
    q=10**U(-4,0)*.99
    if cls in('thin','near_tangent_thin'): q=10**U(-4,-2)
    if cls=='fat': q=R.choice([.9,.99,.999,1-1e-6,1-1e-12])
    b=a*q
    L=a*10**U(-.5,2)
    if cls in('far','near_tangent_far'): L=a*10**U(3,6)
    k=10**U(-3,3) if R.random()<.4 else 1.
    u,v=U(0,6.2831853),U(0,6.2831853)
    p,n=surf(a,b,u,v)
    if cls in('far','thin','fat','random'):
        if R.random()<.8:
            d=vec(); s=U(-1,1) if R.random()<.5 else 0
            t=[p[i]-s*b*n[i] for i in range(3)]; o=[t[i]-L*d[i] for i in range(3)]
        else:
            d=vec(); o=[a*x*2 for x in vec()]; 
    elif cls.startswith('near_tangent'):
        w=vec(); e=sum(x*y for x,y in zip(w,n)); d=[w[i]-e*n[i] for i in range(3)]; m=sum(x*x for x in d)**.5; d=[x/m for x in d]
        eta=10**U(-11,-3)*R.choice([-1,1])
        t=[p[i]+eta*b*n[i] for i in range(3)]; o=[t[i]-L*d[i] for i in range(3)]
    elif cls=='parallel':
        d=[0.,0.,R.choice([-1.,1.])]; r=R.choice([a,a-b,a+b,U(a-b,a+b),(a-b)*(1+10**U(-11,-2)),(a+b)*(1-10**U(-11,-2)),0.]); o=[r*math.cos(u),r*math.sin(u),-d[2]*L] if R.random()<.6 else [r,0.,-d[2]*L]
    elif cls=='equatorial':
        d=[math.cos(u),math.sin(u),0.]; r=U(0,a+b); o=[-L*d[0]-r*d[1],-L*d[1]+r*d[0],0.]
    elif cls=='equatorial_tangent':
        d=[math.cos(u),math.sin(u),0.]; r=R.choice([a-b,a+b])*(1+R.choice([-1,1])*10**U(-12,-3)); o=[-L*d[0]-r*d[1],-L*d[1]+r*d[0],0.]
    elif cls=='on_surface':
        d=vec(); o=[p[i]+R.choice([0,1,-1])*10**U(-14,-3)*b*n[i] for i in range(3)]
    elif cls=='inside':
        d=vec(); s=U(0,1); o=[p[i]-s*b*n[i] for i in range(3)]
    elif cls=='hole':
        d=vec(); o=[x*(a-b)*.9 for x in vec()]; o[2]*=.1
    elif cls=='plane_contact':
        z=b*(1+R.choice([-1,1])*10**U(-12,-2)); d=[math.cos(u),math.sin(u),0.]; r=U(0,a+b); o=[-L*d[0]-r*d[1],-L*d[1]+r*d[0],z]
        if R.random()<.5: d[2]=10**U(-14,-4)*R.choice([-1,1]); 
    elif cls=='axis_tiny':
        d=[10**U(-20,-5),10**U(-20,-5)*R.choice([0,1]),R.choice([-1.,1.])]; o=[p[0],p[1],-d[2]*L]; 
        if R.random()<.5: d=[d[2],d[0],d[1]]; o=[-d[0]*L,p[1],p[2]]
    elif cls=='villarceau':
        th=math.asin(b/a) ; d0=[math.cos(th),0,math.sin(th)]; ph=U(0,6.28)
        w=[0.,1.,0.]; d=[d0[i]*math.cos(ph)+w[i]*math.sin(ph) for i in range(3)]
        c=U(-1,1)*a; q_=[ -d0[i]*math.sin(ph)*c+w[i]*math.cos(ph)*c for i in range(3)]
        # through the bitangent plane, nearly through the tangent points
        o=[q_[i]*(1 if R.random()<.5 else 10**U(-12,-2))-L*d[i] for i in range(3)]
        if R.random()<.5: d=d0; o=[-L*x for x in d0]; o[1]+=a*10**U(-8,-2)*R.choice([0,1,-1])
    elif cls=='vertical_tangent':
        d=[0.,math.cos(v),math.sin(v)]; x=R.choice([a+b,a-b])*(1+R.choice([-1,1])*10**U(-12,-2)); o=[x,-L*d[1],-L*d[2]]
    if R.random()<.15 and cls not in('on_surface','inside','hole'):  # start among the roots
        s=L+U(-1,1)*b; o=[o[i]+s*d[i] for i in range(3)]
    d=[x*k for x in d]
    return torus_row(cls,a,b,o,d)
def gen_quartic():
    cls=R.choice(['random','huge','ratio','ratio_extreme','near_double','near_triple','near_quad','two_double','complex_near','complex_ratio','scaled_double','biquad','sparse','int'])
    rs=None; mp.mp.dps=60
    sg=lambda: R.choice([-1,1])
    if cls=='random': rs=[mpf(U(-5,5)) for _ in range(4)]
    elif cls=='huge':
        s=mpf(10)**U(-60,60); rs=[mpf(U(-5,5))*s for _ in range(4)]
    elif cls=='ratio': rs=[sg()*mpf(10)**U(-12,12) for _ in range(4)]
    elif cls=='ratio_extreme': rs=[sg()*mpf(10)**U(-70,70) for _ in range(4)]
    elif cls in('near_double','scaled_double'):
        s=mpf(10)**U(-8,8) if cls=='scaled_double' else mpf(1)
        x=mpf(U(-3,3)); e=mpf(10)**U(-10,-1); rs=[x*s,(x*(1+e))*s,mpf(U(-3,3))*(1 if R.random()<.5 else mpf(10)**U(-6,6)),mpf(U(-3,3))]
    elif cls=='near_triple':
        x=mpf(U(-3,3)); e=mpf(10)**U(-6,-1); rs=[x,x*(1+e),x*(1+e*U(-2,2)),mpf(U(-3,3))]
    elif cls=='near_quad':
        x=mpf(U(-3,3)); e=mpf(10)**U(-4,-1); rs=[x*(1+e*U(-1,1)) for _ in range(4)]
    elif cls=='two_double':
        x,y=mpf(U(-3,3)),mpf(U(-3,3)); e=mpf(10)**U(-8,-1); f=mpf(10)**U(-8,-1); rs=[x,x*(1+e),y,y*(1+f)]
    elif cls=='complex_near':
        x=mpf(U(-3,3)); e=mpf(10)**U(-8,-1); z=mp.mpc(x,x*e); y=mpf(U(-3,3)); w=mp.mpc(y,y*mpf(10)**U(-8,0)); rs=[z,mp.conj(z)]+([w,mp.conj(w)] if R.random()<.5 else [y,mpf(U(-3,3))])
    elif cls=='complex_ratio':
        z=mp.mpc(U(-1,1),U(-1,1))*mpf(10)**U(-10,10); w=mp.mpc(U(-1,1),U(-1,1))*mpf(10)**U(-10,10); rs=[z,mp.conj(z)]+([w,mp.conj(w)] if R.random()<.3 else [sg()*mpf(10)**U(-10,10),sg()*mpf(10)**U(-10,10)])
    if rs is not None:
        p=[mpf(1)]
        for r in rs:
            p=[ (p[i] if i<len(p) else 0)-(r*p[i-1] if i>0 else 0) for i in range(len(p)+1)]
        c=[float(mp.re(x)) for x in p[1:]]
        init=None
    elif cls=='biquad':
        c=[0.,U(-5,5)*10**U(-5,5),0.,U(-5,5)*10**U(-5,5)]
    elif cls=='sparse':
        c=[R.choice([0.,U(-5,5)*10**U(-20,20)]) for _ in range(4)]
    else: c=[float(R.randint(-9,9)) for _ in range(4)]
    mp.mp.dps=150
    if any(x!=x or abs(x)==float('inf') for x in c): return gen_quartic()
    cm=[mpf(1)]+[mpf(x) for x in c]
    # start Durand–Kerner from slightly moved planned roots
    init=[mp.mpc(r)*(1+mp.mpc(0.01*(i+1),0.013*(i+2))) for i,r in enumerate(rs)] if rs is not None else None
    try: rr=real_distinct(cm,init)
    except RuntimeError: return gen_quartic()
    def parts(x): 
        return sum(cm[4-k]*x**k for k in range(5)), sum(abs(cm[4-k]*x**k) for k in range(5)), sum(k*cm[4-k]*x**(k-1) for k in range(1,5))
    dc=[4,3*cm[1],2*cm[2],cm[3]]
    try: crit=real_distinct(dc)
    except RuntimeError: return gen_quartic()
    mg=[]
    for x in crit:
        f,w,_=parts(x); mg.append(abs(f)/w if w!=0 else mpf(0))
    row={'cls':cls,'a3':g(c[0]),'a2':g(c[1]),'a1':g(c[2]),'a0':g(c[3]),'n_real_distinct':len(rr),'margin':g(min(mg)) if mg else '1'}
    for k in range(4): row[f'r{k}']=row[f'cond{k}']=''
    for k,x in enumerate(rr):
        f,w,df=parts(x); row[f'r{k}']=g(x); row[f'cond{k}']=('0' if x==0 else g(sum(abs(cm[4-j]*x**j) for j in range(4))/abs(x*df))) if df!=0 else 'inf'
    return row
rows=[]
while len(rows)<N:
    try: rows.append(gen_torus() if sys.argv[1]=='ray_torus' else gen_quartic())
    except RuntimeError: pass
w=csv.DictWriter(open(sys.argv[4],'w',newline=''),list(rows[0])); w.writeheader(); w.writerows(rows)
