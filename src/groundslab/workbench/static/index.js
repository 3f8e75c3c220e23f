/*!
This file holds groundslab's own code and these libraries:

three

The MIT License

Copyright © 2010-2026 three.js authors

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.

uplot

The MIT License (MIT)

Copyright (c) 2022 Leon Sorokin

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.
*/
(function(){let e=document.createElement(`link`).relList;if(e&&e.supports&&e.supports(`modulepreload`))return;for(let e of document.querySelectorAll(`link[rel="modulepreload"]`))n(e);new MutationObserver(e=>{for(let t of e)if(t.type===`childList`)for(let e of t.addedNodes)e.tagName===`LINK`&&e.rel===`modulepreload`&&n(e)}).observe(document,{childList:!0,subtree:!0});function t(e){let t={};return e.integrity&&(t.integrity=e.integrity),e.referrerPolicy&&(t.referrerPolicy=e.referrerPolicy),t.credentials=e.crossOrigin===`use-credentials`?`include`:e.crossOrigin===`anonymous`?`omit`:`same-origin`,t}function n(e){if(e.ep)return;e.ep=!0;let n=t(e);fetch(e.href,n)}})();var e=class extends Error{},t=2,n={u8:1,u16:2,u32:4,i32:4,f32:4};function r(n){if(n.byteLength<4)throw new e(`The results are empty.`);let r=new DataView(n).getUint32(0,!0);if(4+r>n.byteLength)throw new e(`The results are cut off.`);let i=JSON.parse(new TextDecoder().decode(new Uint8Array(n,4,r)));if(i.format!==t)throw new e(`The results have format ${i.format}; this page reads format ${t}.`);let s=Math.ceil((4+r)/8)*8,c=a(n,s,i.mesh.nodes),l=o(n,s,i.mesh.elements),u=l instanceof Uint32Array?l:Uint32Array.from(l),d=c.length/2;for(let t of u)if(t>=d)throw new e(`The results are damaged: an element names a node that is not there.`);return{head:i,data:n,start:s,mesh:{nodes:c,elements:u,section:i.mesh.section?Uint16Array.from(o(n,s,i.mesh.section)):null,nodeCount:d,elementCount:u.length/9}}}function i(e,t){return a(e.data,e.start,t)}function a(e,t,n){let r=o(e,t,n);if(r instanceof Float32Array&&n.scale===1&&n.shift===0)return r;let i=new Float32Array(r.length),{scale:a,shift:s}=n;for(let e=0;e<r.length;e++)i[e]=a*r[e]+s;return i}function o(t,r,i){let a=i.shape.reduce((e,t)=>e*t,1),o=r+i.offset;if(o+a*n[i.type]>t.byteLength)throw new e(`The results are cut off.`);switch(i.type){case`u8`:return new Uint8Array(t,o,a);case`u16`:return new Uint16Array(t,o,a);case`u32`:return new Uint32Array(t,o,a);case`i32`:return new Int32Array(t,o,a);case`f32`:return new Float32Array(t,o,a)}}var s=`contact`,c=[`moment_x`,`moment_y`,`moment_xy`],l=[{name:`m_1`,symbol:`m_1`,meaning:`larger principal moment`},{name:`m_2`,symbol:`m_2`,meaning:`smaller principal moment`},{name:`bottom_x`,symbol:`m_x bottom`,meaning:`design moment bottom x, for reinforcement along x (Wood and Armer)`},{name:`bottom_y`,symbol:`m_y bottom`,meaning:`design moment bottom y, for reinforcement along y (Wood and Armer)`},{name:`top_x`,symbol:`m_x top`,meaning:`design moment top x, for reinforcement along x (Wood and Armer)`},{name:`top_y`,symbol:`m_y top`,meaning:`design moment top y, for reinforcement along y (Wood and Armer)`}];function u(e){let t=e.head.fields.filter(e=>e.name!==s).map(e=>({...e,derived:!1})),n=t.find(e=>e.name===c[0]);return!n||!c.every(e=>t.some(t=>t.name===e))?t:[...t,...l.map(e=>({...e,unit:n.unit,averaged:`derived from m_x, m_y and m_xy at the nodes`,signed:!0,derived:!0}))]}function d(e,t,n){let r=C(e,t,n),i=v(t)?void 0:e.head.combinations[t]?.extremes[n],{min:a,max:o,minNode:s,maxNode:c}=E(r),l=t=>[e.mesh.nodes[2*t],e.mesh.nodes[2*t+1]];return{min:i?.min??[a,...l(s)],max:i?.max??[o,...l(c)]}}function f(e,t){let n=y(e,t).map(t=>e.head.combinations[t]?.extremes.line_force?.max).filter(e=>e!==void 0);return n.length?n.reduce((e,t)=>t[0]>e[0]?t:e):null}function p(e,t){let n=u(e).find(e=>e.name===t);if(!n)throw RangeError(`no field ${t}`);return n}function m(e,t,n){let[r,i]=[(e+t)/2,Math.hypot((e-t)/2,n)];return[r+i,r-i]}function h(e,t,n){return Math.atan2(2*n,e-t)*90/Math.PI}function g(e,t,n){let r=Math.abs(n),[i,a]=[e+r,t+r];return i<0&&a<0?[0,0]:i<0?[0,Math.max(t+n*n/Math.abs(e),0)]:a<0?[Math.max(e+n*n/Math.abs(t),0),0]:[i,a]}function _(e,t,n,r){switch(e){case`m_1`:return m(t,n,r)[0];case`m_2`:return m(t,n,r)[1];case`bottom_x`:return g(t,n,r)[0];case`bottom_y`:return g(t,n,r)[1];case`top_x`:return 0-g(-t,-n,r)[0];case`top_y`:return 0-g(-t,-n,r)[1];default:throw RangeError(`no derived field ${e}`)}}function v(e){return typeof e!=`number`}function y(e,t){if(!v(t))return[t];let[,n]=j(t);return e.head.combinations.flatMap((e,t)=>e.values!==null&&e.certified&&(n===null||e.limit_state===n)?[t]:[])}function b(e){let t=y(e,`largest`).map(t=>e.head.combinations[t].limit_state);if(t.length<2)return[];let n=[...new Set(t)];return n.length===1?[`largest`,`smallest`]:[...n.filter(e=>t.filter(t=>t===e).length>1).flatMap(e=>[`largest:${e}`,`smallest:${e}`]),`largest`,`smallest`]}function x(e,t){if(!v(t)){let n=e.head.combinations[t];return n?e.head.combinations.length>1?`${n.number} ${n.name}`:n.name:``}let[n,r]=j(t);return`${n} of ${r===null?`all`:`all ${r}`} combinations`}function S(e){return/^\d+$/.test(e)?Number(e):e}function C(e,t,n){let r=`${t} ${n}`,i=k(e),a=i.get(r);if(a)return i.delete(r),i.set(r,a),a;let o=v(t)?ee(e,t,n):N(e,t,n);i.set(r,o);for(let[e,t]of i){if(A(i)<=D||t===o)break;i.delete(e)}return o}function w(e,t,n,r,i){let a={value:NaN,from:-1},o=!v(n)||j(n)[0]===`largest`;for(let s of y(e,n)){let n=te(e,t,s,r,i);(a.from<0||(o?n>a.value:n<a.value))&&(a={value:n,from:s})}return a}function T(e,t,n,r){return e.head.fields.some(e=>e.name===`contact`)?y(e,n).every(n=>t.interpolate(C(e,n,s),r)<0):null}function E(e){let[t,n]=[0,0];for(let r=1;r<e.length;r++)e[r]<e[t]&&(t=r),e[r]>e[n]&&(n=r);return{min:e[t]??NaN,max:e[n]??NaN,minNode:t,maxNode:n}}var D=256e6,O=new WeakMap;function k(e){let t=O.get(e);return t||O.set(e,t=new Map),t}function A(e){let t=0;for(let n of e.values())t+=n.byteLength;return t}function j(e){let t=e.indexOf(`:`);return[t<0?e:e.slice(0,t),t<0?null:e.slice(t+1)]}function M(e){return l.some(t=>t.name===e)}function N(e,t,n){if(M(n)){let[r,i,a]=c.map(n=>C(e,t,n));return r.map((e,t)=>_(n,e,i[t],a[t]))}let r=e.head.combinations[t]?.values?.[n];if(!r)throw RangeError(`no values of ${n} in combination ${t}`);return i(e,r)}function ee(e,t,n){let r=y(e,t);if(!r.length)throw RangeError(`no combination for this envelope`);let i=n===`contact`||j(t)[0]===`largest`,a=N(e,r[0],n).slice();for(let t of r.slice(1)){let r=N(e,t,n);for(let e=0;e<a.length;e++)(i?r[e]>a[e]:r[e]<a[e])&&(a[e]=r[e])}return a}function te(e,t,n,r,i){if(!M(r))return t.interpolate(C(e,n,r),i);let[a,o,s]=c.map(r=>t.interpolate(C(e,n,r),i));return _(r,a,o,s)}var ne=[0,2,2,0,1,2,1,0,1],re=[0,0,2,2,0,1,2,1,1],ie=[0,4,8,4,1,8,1,5,8,5,2,8,2,6,8,6,3,8,3,7,8,7,0,8],P=[0,1,2,0,2,3],ae=[[0,1,4],[1,2,5],[2,3,6],[3,0,7]];function F(e){return[e*(e-1)/2,1-e*e,e*(e+1)/2]}function I(e){return[e-.5,-2*e,e+.5]}function L(e,t){let n=F(e),r=F(t);return ne.map((e,t)=>n[e]*r[re[t]])}function oe(e,t){let[n,r,i,a]=[F(e),F(t),I(e),I(t)];return[ne.map((e,t)=>i[e]*r[re[t]]),ne.map((e,t)=>n[e]*a[re[t]])]}var se=.125,ce=1e-4,le=class{mesh;low;size;count;first;held;last=0;constructor(e){this.mesh=e;let t=fe(e),[n,r,i,a]=[1/0,1/0,-1/0,-1/0];for(let o=0;o<e.elementCount;o++)n=Math.min(n,t[4*o]),r=Math.min(r,t[4*o+1]),i=Math.max(i,t[4*o+2]),a=Math.max(a,t[4*o+3]);let[o,s]=[Math.max(i-n,1e-9),Math.max(a-r,1e-9)],c=Math.sqrt(o*s/Math.max(e.elementCount,1)),l=e=>Math.min(2048,Math.max(1,Math.round(e/c)));this.low=[n,r],this.count=[l(o),l(s)],this.size=[o/this.count[0],s/this.count[1]],this.first=new Uint32Array(this.count[0]*this.count[1]+1);let u=n=>{for(let r=0;r<e.elementCount;r++){let[e,i]=this.bucket(t[4*r],t[4*r+1]),[a,o]=this.bucket(t[4*r+2],t[4*r+3]);for(let t=i;t<=o;t++)for(let i=e;i<=a;i++)n(t*this.count[0]+i,r)}};u(e=>{this.first[e+1]+=1});for(let e=0;e+1<this.first.length;e++)this.first[e+1]+=this.first[e];let d=this.first.slice();this.held=new Uint32Array(this.first[this.first.length-1]),u((e,t)=>{this.held[d[e]++]=t})}at(e,t){let[n,r]=[(e-this.low[0])/this.size[0],(t-this.low[1])/this.size[1]];if(!(n>=-1e-4&&r>=-1e-4&&n<=this.count[0]+ce&&r<=this.count[1]+ce))return null;let i=this.in(this.last,e,t);if(i&&de(i)<=1)return i;let[a,o]=this.bucket(e,t),s=o*this.count[0]+a,c=null;for(let n=this.first[s];n<this.first[s+1];n++){let r=this.in(this.held[n],e,t);if(r&&(c===null||de(r)<de(c))&&(c=r),c&&de(c)<=1)break}return!c||de(c)>1.0001?null:(this.last=c.element,c)}interpolate(e,t){let n=L(t.xi,t.eta),{elements:r}=this.mesh,i=0;for(let a=0;a<9;a++)i+=n[a]*e[r[9*t.element+a]];return i}bucket(e,t){let n=(e,t)=>Math.min(this.count[t]-1,Math.max(0,Math.floor(e/this.size[t])));return[n(e-this.low[0],0),n(t-this.low[1],1)]}in(e,t,n){let{nodes:r,elements:i}=this.mesh;if(e>=this.mesh.elementCount)return null;let[a,o]=[0,0];for(let s=0;s<20;s++){let s=L(a,o),[c,l]=oe(a,o),[u,d,f,p,m,h]=[t,n,0,0,0,0];for(let t=0;t<9;t++){let n=2*i[9*e+t],[a,o]=[r[n],r[n+1]];u-=s[t]*a,d-=s[t]*o,f+=c[t]*a,p+=c[t]*o,m+=l[t]*a,h+=l[t]*o}let g=f*h-p*m;if(g===0)return null;let _=[a+(h*u-m*d)/g,o+(f*d-p*u)/g],[v,y]=[ue(_[0]),ue(_[1])],b=Math.max(Math.abs(v-a),Math.abs(y-o));if([a,o]=[v,y],b<1e-10)break}return{element:e,xi:a,eta:o}}};function ue(e){return Math.min(1.5,Math.max(-1.5,e))}function de(e){return Math.max(Math.abs(e.xi),Math.abs(e.eta))}function fe(e){let t=new Float64Array(4*e.elementCount);for(let n=0;n<e.elementCount;n++){let[r,i,a,o]=[1/0,1/0,-1/0,-1/0];for(let t=0;t<9;t++){let s=2*e.elements[9*n+t],[c,l]=[e.nodes[s],e.nodes[s+1]];r=Math.min(r,c),i=Math.min(i,l),a=Math.max(a,c),o=Math.max(o,l)}let[s,c]=[se*(a-r),se*(o-i)];t.set([r-s,i-c,a+s,o+c],4*n)}return t}var pe={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},me={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},he=1e3,ge=1001,_e=1002,ve=1003,ye=1004,be=1005,R=1006,z=1007,B=1008,xe=1009,V=1010,Se=1011,Ce=1012,H=1013,we=1014,Te=1015,Ee=1016,De=1017,Oe=1018,ke=1020,U=35902,W=35899,Ae=1021,je=1022,Me=1023,Ne=1026,Pe=1027,Fe=1028,Ie=1029,Le=1030,Re=1031,ze=1033,Be=33776,Ve=33777,He=33778,Ue=33779,We=35840,Ge=35841,Ke=35842,qe=35843,Je=36196,Ye=37492,Xe=37496,Ze=37488,Qe=37489,$e=37490,et=37491,tt=37808,nt=37809,rt=37810,it=37811,at=37812,ot=37813,st=37814,ct=37815,lt=37816,ut=37817,dt=37818,ft=37819,pt=37820,mt=37821,ht=36492,gt=36494,_t=36495,vt=36283,yt=36284,bt=36285,xt=36286,St=2300,Ct=2301,wt=2302,Tt=2303,Et=2400,Dt=2401,Ot=2402,kt=3200,At=`srgb`,jt=`srgb-linear`,Mt=`linear`,Nt=`srgb`,Pt=7680,Ft=35044,It=`300 es`,Lt=2e3;function Rt(e){for(let t=e.length-1;t>=0;--t)if(e[t]>=65535)return!0;return!1}function zt(e){return ArrayBuffer.isView(e)&&!(e instanceof DataView)}function Bt(e){return document.createElementNS(`http://www.w3.org/1999/xhtml`,e)}function Vt(){let e=Bt(`canvas`);return e.style.display=`block`,e}var Ht={};function Ut(...e){let t=`THREE.`+e.shift();console.log(t,...e)}function Wt(e){let t=e[0];if(typeof t==`string`&&t.startsWith(`TSL:`)){let t=e[1];t&&t.isStackTrace?e[0]+=` `+t.getLocation():e[1]=`Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.`}return e}function G(...e){e=Wt(e);let t=`THREE.`+e.shift();{let n=e[0];n&&n.isStackTrace?console.warn(n.getError(t)):console.warn(t,...e)}}function K(...e){e=Wt(e);let t=`THREE.`+e.shift();{let n=e[0];n&&n.isStackTrace?console.error(n.getError(t)):console.error(t,...e)}}function Gt(...e){let t=e.join(` `);t in Ht||(Ht[t]=!0,G(...e))}function Kt(e,t,n){return new Promise(function(r,i){function a(){switch(e.clientWaitSync(t,e.SYNC_FLUSH_COMMANDS_BIT,0)){case e.WAIT_FAILED:i();break;case e.TIMEOUT_EXPIRED:setTimeout(a,n);break;default:r()}}setTimeout(a,n)})}var qt={0:0,2:6,4:4,3:5,1:1,6:2,7:7,5:3},Jt=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n!==void 0&&n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let r=n[e];if(r!==void 0){let e=r.indexOf(t);e!==-1&&r.splice(e,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let t=n.slice(0);for(let n=0,r=t.length;n<r;n++)t[n].call(this,e);e.target=null}}},Yt=`00.01.02.03.04.05.06.07.08.09.0a.0b.0c.0d.0e.0f.10.11.12.13.14.15.16.17.18.19.1a.1b.1c.1d.1e.1f.20.21.22.23.24.25.26.27.28.29.2a.2b.2c.2d.2e.2f.30.31.32.33.34.35.36.37.38.39.3a.3b.3c.3d.3e.3f.40.41.42.43.44.45.46.47.48.49.4a.4b.4c.4d.4e.4f.50.51.52.53.54.55.56.57.58.59.5a.5b.5c.5d.5e.5f.60.61.62.63.64.65.66.67.68.69.6a.6b.6c.6d.6e.6f.70.71.72.73.74.75.76.77.78.79.7a.7b.7c.7d.7e.7f.80.81.82.83.84.85.86.87.88.89.8a.8b.8c.8d.8e.8f.90.91.92.93.94.95.96.97.98.99.9a.9b.9c.9d.9e.9f.a0.a1.a2.a3.a4.a5.a6.a7.a8.a9.aa.ab.ac.ad.ae.af.b0.b1.b2.b3.b4.b5.b6.b7.b8.b9.ba.bb.bc.bd.be.bf.c0.c1.c2.c3.c4.c5.c6.c7.c8.c9.ca.cb.cc.cd.ce.cf.d0.d1.d2.d3.d4.d5.d6.d7.d8.d9.da.db.dc.dd.de.df.e0.e1.e2.e3.e4.e5.e6.e7.e8.e9.ea.eb.ec.ed.ee.ef.f0.f1.f2.f3.f4.f5.f6.f7.f8.f9.fa.fb.fc.fd.fe.ff`.split(`.`),Xt=1234567,Zt=Math.PI/180,Qt=180/Math.PI;function $t(){let e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0,r=Math.random()*4294967295|0;return(Yt[e&255]+Yt[e>>8&255]+Yt[e>>16&255]+Yt[e>>24&255]+`-`+Yt[t&255]+Yt[t>>8&255]+`-`+Yt[t>>16&15|64]+Yt[t>>24&255]+`-`+Yt[n&63|128]+Yt[n>>8&255]+`-`+Yt[n>>16&255]+Yt[n>>24&255]+Yt[r&255]+Yt[r>>8&255]+Yt[r>>16&255]+Yt[r>>24&255]).toLowerCase()}function en(e,t,n){return Math.max(t,Math.min(n,e))}function tn(e,t){return(e%t+t)%t}function nn(e,t,n,r,i){return r+(e-t)*(i-r)/(n-t)}function rn(e,t,n){return e===t?0:(n-e)/(t-e)}function an(e,t,n){return(1-n)*e+n*t}function on(e,t,n,r){return an(e,t,1-Math.exp(-n*r))}function sn(e,t=1){return t-Math.abs(tn(e,t*2)-t)}function cn(e,t,n){return e<=t?0:e>=n?1:(e=(e-t)/(n-t),e*e*(3-2*e))}function ln(e,t,n){return e<=t?0:e>=n?1:(e=(e-t)/(n-t),e*e*e*(e*(e*6-15)+10))}function un(e,t){return e+Math.floor(Math.random()*(t-e+1))}function dn(e,t){return e+Math.random()*(t-e)}function fn(e){return e*(.5-Math.random())}function pn(e){e!==void 0&&(Xt=e);let t=Xt+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function mn(e){return e*Zt}function hn(e){return e*Qt}function gn(e){return e>0&&Number.isInteger(e)&&2**Math.round(Math.log2(e))===e}function _n(e){return 2**Math.ceil(Math.log(e)/Math.LN2)}function vn(e){return 2**Math.floor(Math.log(e)/Math.LN2)}function yn(e,t,n,r,i){let a=Math.cos,o=Math.sin,s=a(n/2),c=o(n/2),l=a((t+r)/2),u=o((t+r)/2),d=a((t-r)/2),f=o((t-r)/2),p=a((r-t)/2),m=o((r-t)/2);switch(i){case`XYX`:e.set(s*u,c*d,c*f,s*l);break;case`YZY`:e.set(c*f,s*u,c*d,s*l);break;case`ZXZ`:e.set(c*d,c*f,s*u,s*l);break;case`XZX`:e.set(s*u,c*m,c*p,s*l);break;case`YXY`:e.set(c*p,s*u,c*m,s*l);break;case`ZYZ`:e.set(c*m,c*p,s*u,s*l);break;default:G(`MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: `+i)}}function bn(e){switch(e.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function xn(e,t){if(t.constructor===Float32Array)return e;let n=bn(t);if(n===void 0)throw Error(`THREE.MathUtils: Invalid component type.`);return Math.max(e/n,-1)}function Sn(e,t){if(t.constructor===Float32Array)return e;let n=bn(t);if(n===void 0)throw Error(`THREE.MathUtils: Invalid component type.`);return Math.round(e*n)}var Cn={DEG2RAD:Zt,RAD2DEG:Qt,generateUUID:$t,clamp:en,euclideanModulo:tn,mapLinear:nn,inverseLerp:rn,lerp:an,damp:on,pingpong:sn,smoothstep:cn,smootherstep:ln,randInt:un,randFloat:dn,randFloatSpread:fn,seededRandom:pn,degToRad:mn,radToDeg:hn,isPowerOfTwo:gn,ceilPowerOfTwo:_n,floorPowerOfTwo:vn,setQuaternionFromProperEuler:yn,normalize:Sn,denormalize:xn},q=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw Error(`THREE.Vector2: index is out of range: `+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw Error(`THREE.Vector2: index is out of range: `+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6],this.y=r[1]*t+r[4]*n+r[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=en(this.x,e.x,t.x),this.y=en(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=en(this.x,e,t),this.y=en(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(en(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(en(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),r=Math.sin(t),i=this.x-e.x,a=this.y-e.y;return this.x=i*n-a*r+e.x,this.y=i*r+a*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},wn=class{constructor(e=0,t=0,n=0,r=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=r}static slerpFlat(e,t,n,r,i,a,o){let s=n[r+0],c=n[r+1],l=n[r+2],u=n[r+3],d=i[a+0],f=i[a+1],p=i[a+2],m=i[a+3];if(u!==m||s!==d||c!==f||l!==p){let e=s*d+c*f+l*p+u*m;e<0&&(d=-d,f=-f,p=-p,m=-m,e=-e);let t=1-o;if(e<.9995){let n=Math.acos(e),r=Math.sin(n);t=Math.sin(t*n)/r,o=Math.sin(o*n)/r,s=s*t+d*o,c=c*t+f*o,l=l*t+p*o,u=u*t+m*o}else{s=s*t+d*o,c=c*t+f*o,l=l*t+p*o,u=u*t+m*o;let e=1/Math.sqrt(s*s+c*c+l*l+u*u);s*=e,c*=e,l*=e,u*=e}}e[t]=s,e[t+1]=c,e[t+2]=l,e[t+3]=u}static multiplyQuaternionsFlat(e,t,n,r,i,a){let o=n[r],s=n[r+1],c=n[r+2],l=n[r+3],u=i[a],d=i[a+1],f=i[a+2],p=i[a+3];return e[t]=o*p+l*u+s*f-c*d,e[t+1]=s*p+l*d+c*u-o*f,e[t+2]=c*p+l*f+o*d-s*u,e[t+3]=l*p-o*u-s*d-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,r){return this._x=e,this._y=t,this._z=n,this._w=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,r=e._y,i=e._z,a=e._order,o=Math.cos,s=Math.sin,c=o(n/2),l=o(r/2),u=o(i/2),d=s(n/2),f=s(r/2),p=s(i/2);switch(a){case`XYZ`:this._x=d*l*u+c*f*p,this._y=c*f*u-d*l*p,this._z=c*l*p+d*f*u,this._w=c*l*u-d*f*p;break;case`YXZ`:this._x=d*l*u+c*f*p,this._y=c*f*u-d*l*p,this._z=c*l*p-d*f*u,this._w=c*l*u+d*f*p;break;case`ZXY`:this._x=d*l*u-c*f*p,this._y=c*f*u+d*l*p,this._z=c*l*p+d*f*u,this._w=c*l*u-d*f*p;break;case`ZYX`:this._x=d*l*u-c*f*p,this._y=c*f*u+d*l*p,this._z=c*l*p-d*f*u,this._w=c*l*u+d*f*p;break;case`YZX`:this._x=d*l*u+c*f*p,this._y=c*f*u+d*l*p,this._z=c*l*p-d*f*u,this._w=c*l*u-d*f*p;break;case`XZY`:this._x=d*l*u-c*f*p,this._y=c*f*u-d*l*p,this._z=c*l*p+d*f*u,this._w=c*l*u+d*f*p;break;default:G(`Quaternion: .setFromEuler() encountered an unknown order: `+a)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,r=Math.sin(n);return this._x=e.x*r,this._y=e.y*r,this._z=e.z*r,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],r=t[4],i=t[8],a=t[1],o=t[5],s=t[9],c=t[2],l=t[6],u=t[10],d=n+o+u;if(d>0){let e=.5/Math.sqrt(d+1);this._w=.25/e,this._x=(l-s)*e,this._y=(i-c)*e,this._z=(a-r)*e}else if(n>o&&n>u){let e=2*Math.sqrt(1+n-o-u);this._w=(l-s)/e,this._x=.25*e,this._y=(r+a)/e,this._z=(i+c)/e}else if(o>u){let e=2*Math.sqrt(1+o-n-u);this._w=(i-c)/e,this._x=(r+a)/e,this._y=.25*e,this._z=(s+l)/e}else{let e=2*Math.sqrt(1+u-n-o);this._w=(a-r)/e,this._x=(i+c)/e,this._y=(s+l)/e,this._z=.25*e}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(en(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let r=Math.min(1,t/n);return this.slerp(e,r),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x*=e,this._y*=e,this._z*=e,this._w*=e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,r=e._y,i=e._z,a=e._w,o=t._x,s=t._y,c=t._z,l=t._w;return this._x=n*l+a*o+r*c-i*s,this._y=r*l+a*s+i*o-n*c,this._z=i*l+a*c+n*s-r*o,this._w=a*l-n*o-r*s-i*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,r=e._y,i=e._z,a=e._w,o=this.dot(e);o<0&&(n=-n,r=-r,i=-i,a=-a,o=-o);let s=1-t;if(o<.9995){let e=Math.acos(o),c=Math.sin(e);s=Math.sin(s*e)/c,t=Math.sin(t*e)/c,this._x=this._x*s+n*t,this._y=this._y*s+r*t,this._z=this._z*s+i*t,this._w=this._w*s+a*t,this._onChangeCallback()}else this._x=this._x*s+n*t,this._y=this._y*s+r*t,this._z=this._z*s+i*t,this._w=this._w*s+a*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),r=Math.sqrt(1-n),i=Math.sqrt(n);return this.set(r*Math.sin(e),r*Math.cos(e),i*Math.sin(t),i*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},J=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw Error(`THREE.Vector3: index is out of range: `+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw Error(`THREE.Vector3: index is out of range: `+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(En.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(En.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,r=this.z,i=e.elements;return this.x=i[0]*t+i[3]*n+i[6]*r,this.y=i[1]*t+i[4]*n+i[7]*r,this.z=i[2]*t+i[5]*n+i[8]*r,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,r=this.z,i=e.elements,a=1/(i[3]*t+i[7]*n+i[11]*r+i[15]);return this.x=(i[0]*t+i[4]*n+i[8]*r+i[12])*a,this.y=(i[1]*t+i[5]*n+i[9]*r+i[13])*a,this.z=(i[2]*t+i[6]*n+i[10]*r+i[14])*a,this}applyQuaternion(e){let t=this.x,n=this.y,r=this.z,i=e.x,a=e.y,o=e.z,s=e.w,c=2*(a*r-o*n),l=2*(o*t-i*r),u=2*(i*n-a*t);return this.x=t+s*c+a*u-o*l,this.y=n+s*l+o*c-i*u,this.z=r+s*u+i*l-a*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,r=this.z,i=e.elements;return this.x=i[0]*t+i[4]*n+i[8]*r,this.y=i[1]*t+i[5]*n+i[9]*r,this.z=i[2]*t+i[6]*n+i[10]*r,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=en(this.x,e.x,t.x),this.y=en(this.y,e.y,t.y),this.z=en(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=en(this.x,e,t),this.y=en(this.y,e,t),this.z=en(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(en(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,r=e.y,i=e.z,a=t.x,o=t.y,s=t.z;return this.x=r*s-i*o,this.y=i*a-n*s,this.z=n*o-r*a,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return Tn.copy(this).projectOnVector(e),this.sub(Tn)}reflect(e){return this.sub(Tn.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(en(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,r=this.z-e.z;return t*t+n*n+r*r}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let r=Math.sin(t)*e;return this.x=r*Math.sin(n),this.y=Math.cos(t)*e,this.z=r*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),r=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=r,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Tn=new J,En=new wn,Y=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,r,i,a,o,s,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,r,i,a,o,s,c)}set(e,t,n,r,i,a,o,s,c){let l=this.elements;return l[0]=e,l[1]=r,l[2]=o,l[3]=t,l[4]=i,l[5]=s,l[6]=n,l[7]=a,l[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,r=t.elements,i=this.elements,a=n[0],o=n[3],s=n[6],c=n[1],l=n[4],u=n[7],d=n[2],f=n[5],p=n[8],m=r[0],h=r[3],g=r[6],_=r[1],v=r[4],y=r[7],b=r[2],x=r[5],S=r[8];return i[0]=a*m+o*_+s*b,i[3]=a*h+o*v+s*x,i[6]=a*g+o*y+s*S,i[1]=c*m+l*_+u*b,i[4]=c*h+l*v+u*x,i[7]=c*g+l*y+u*S,i[2]=d*m+f*_+p*b,i[5]=d*h+f*v+p*x,i[8]=d*g+f*y+p*S,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],r=e[2],i=e[3],a=e[4],o=e[5],s=e[6],c=e[7],l=e[8];return t*a*l-t*o*c-n*i*l+n*o*s+r*i*c-r*a*s}invert(){let e=this.elements,t=e[0],n=e[1],r=e[2],i=e[3],a=e[4],o=e[5],s=e[6],c=e[7],l=e[8],u=l*a-o*c,d=o*s-l*i,f=c*i-a*s,p=t*u+n*d+r*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let m=1/p;return e[0]=u*m,e[1]=(r*c-l*n)*m,e[2]=(o*n-r*a)*m,e[3]=d*m,e[4]=(l*t-r*s)*m,e[5]=(r*i-o*t)*m,e[6]=f*m,e[7]=(n*s-c*t)*m,e[8]=(a*t-n*i)*m,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,r,i,a,o){let s=Math.cos(i),c=Math.sin(i);return this.set(n*s,n*c,-n*(s*a+c*o)+a+e,-r*c,r*s,-r*(-c*a+s*o)+o+t,0,0,1),this}scale(e,t){return Gt(`Matrix3: .scale() is deprecated. Use .makeScale() instead.`),this.premultiply(Dn.makeScale(e,t)),this}rotate(e){return Gt(`Matrix3: .rotate() is deprecated. Use .makeRotation() instead.`),this.premultiply(Dn.makeRotation(-e)),this}translate(e,t){return Gt(`Matrix3: .translate() is deprecated. Use .makeTranslation() instead.`),this.premultiply(Dn.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let e=0;e<9;e++)if(t[e]!==n[e])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Dn=new Y,On=new Y().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),kn=new Y().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function An(){let e={enabled:!0,workingColorSpace:jt,spaces:{},convert:function(e,t,n){return this.enabled===!1||t===n||!t||!n||(this.spaces[t].transfer===`srgb`&&(e.r=Mn(e.r),e.g=Mn(e.g),e.b=Mn(e.b)),this.spaces[t].primaries!==this.spaces[n].primaries&&(e.applyMatrix3(this.spaces[t].toXYZ),e.applyMatrix3(this.spaces[n].fromXYZ)),this.spaces[n].transfer===`srgb`&&(e.r=Nn(e.r),e.g=Nn(e.g),e.b=Nn(e.b))),e},workingToColorSpace:function(e,t){return this.convert(e,this.workingColorSpace,t)},colorSpaceToWorking:function(e,t){return this.convert(e,t,this.workingColorSpace)},getPrimaries:function(e){return this.spaces[e].primaries},getTransfer:function(e){return e===``?Mt:this.spaces[e].transfer},getToneMappingMode:function(e){return this.spaces[e].outputColorSpaceConfig.toneMappingMode||`standard`},getLuminanceCoefficients:function(e,t=this.workingColorSpace){return e.fromArray(this.spaces[t].luminanceCoefficients)},define:function(e){Object.assign(this.spaces,e)},_getMatrix:function(e,t,n){return e.copy(this.spaces[n].fromXYZ).multiply(this.spaces[t].toXYZ)},_getDrawingBufferColorSpace:function(e){return this.spaces[e].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(e=this.workingColorSpace){return this.spaces[e].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],n=[.2126,.7152,.0722],r=[.3127,.329];return e.define({[jt]:{primaries:t,whitePoint:r,transfer:Mt,toXYZ:On,fromXYZ:kn,luminanceCoefficients:n,workingColorSpaceConfig:{unpackColorSpace:At},outputColorSpaceConfig:{drawingBufferColorSpace:At}},[At]:{primaries:t,whitePoint:r,transfer:Nt,toXYZ:On,fromXYZ:kn,luminanceCoefficients:n,outputColorSpaceConfig:{drawingBufferColorSpace:At}}}),e}var jn=An();function Mn(e){return e<.04045?e*.0773993808:(e*.9478672986+.0521327014)**2.4}function Nn(e){return e<.0031308?e*12.92:1.055*e**.41666-.055}var Pn,Fn=class{static getDataURL(e,t=`image/png`){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>`u`)return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{Pn===void 0&&(Pn=Bt(`canvas`)),Pn.width=e.width,Pn.height=e.height;let t=Pn.getContext(`2d`);e instanceof ImageData?t.putImageData(e,0,0):t.drawImage(e,0,0,e.width,e.height),n=Pn}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<`u`&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<`u`&&e instanceof HTMLCanvasElement||typeof ImageBitmap<`u`&&e instanceof ImageBitmap){let t=Bt(`canvas`);t.width=e.width,t.height=e.height;let n=t.getContext(`2d`);n.drawImage(e,0,0,e.width,e.height);let r=n.getImageData(0,0,e.width,e.height),i=r.data;for(let e=0;e<i.length;e++)i[e]=Mn(i[e]/255)*255;return n.putImageData(r,0,0),t}if(e.data){let t=e.data.slice(0);for(let e=0;e<t.length;e++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[e]=Math.floor(Mn(t[e]/255)*255):t[e]=Mn(t[e]);return{data:t,width:e.width,height:e.height}}return G(`ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied.`),e}},In=0,Ln=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:In++}),this.uuid=$t(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<`u`&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<`u`&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t===null?e.set(0,0,0):e.set(t.width||0,t.height||0,t.depth||0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e==`string`;if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:``},r=this.data;if(r!==null){let e;if(Array.isArray(r)){e=[];for(let t=0,n=r.length;t<n;t++)r[t].isDataTexture?e.push(Rn(r[t].image)):e.push(Rn(r[t]))}else e=Rn(r);n.url=e}return t||(e.images[this.uuid]=n),n}};function Rn(e){return typeof HTMLImageElement<`u`&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<`u`&&e instanceof HTMLCanvasElement||typeof ImageBitmap<`u`&&e instanceof ImageBitmap?Fn.getDataURL(e):e.data?{data:Array.from(e.data),width:e.width,height:e.height,type:e.data.constructor.name}:(G(`Texture: Unable to serialize Texture.`),{})}var zn=0,Bn=new J,Vn=class e extends Jt{constructor(t=e.DEFAULT_IMAGE,n=e.DEFAULT_MAPPING,r=ge,i=ge,a=R,o=B,s=Me,c=xe,l=e.DEFAULT_ANISOTROPY,u=``){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:zn++}),this.uuid=$t(),this.name=``,this.source=new Ln(t),this.mipmaps=[],this.mapping=n,this.channel=0,this.wrapS=r,this.wrapT=i,this.magFilter=a,this.minFilter=o,this.anisotropy=l,this.format=s,this.internalFormat=null,this.type=c,this.offset=new q(0,0),this.repeat=new q(1,1),this.center=new q(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Y,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Bn).x}get height(){return this.source.getSize(Bn).y}get depth(){return this.source.getSize(Bn).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){G(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let r=this[t];r===void 0?G(`Texture.setValues(): property '${t}' does not exist.`):r&&n&&r.isVector2&&n.isVector2||r&&n&&r.isVector3&&n.isVector3||r&&n&&r.isMatrix3&&n.isMatrix3?r.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e==`string`;if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:`Texture`,generator:`Texture.toJSON`},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:`dispose`})}transformUv(e){if(this.mapping!==300)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case he:e.x-=Math.floor(e.x);break;case ge:e.x=e.x<0?0:1;break;case _e:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x-=Math.floor(e.x)}if(e.y<0||e.y>1)switch(this.wrapT){case he:e.y-=Math.floor(e.y);break;case ge:e.y=e.y<0?0:1;break;case _e:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y-=Math.floor(e.y)}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Vn.DEFAULT_IMAGE=null,Vn.DEFAULT_MAPPING=300,Vn.DEFAULT_ANISOTROPY=1;var Hn=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,r=1){this.x=e,this.y=t,this.z=n,this.w=r}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,r){return this.x=e,this.y=t,this.z=n,this.w=r,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw Error(`THREE.Vector4: index is out of range: `+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw Error(`THREE.Vector4: index is out of range: `+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w===void 0?1:e.w,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,r=this.z,i=this.w,a=e.elements;return this.x=a[0]*t+a[4]*n+a[8]*r+a[12]*i,this.y=a[1]*t+a[5]*n+a[9]*r+a[13]*i,this.z=a[2]*t+a[6]*n+a[10]*r+a[14]*i,this.w=a[3]*t+a[7]*n+a[11]*r+a[15]*i,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,r,i,a=.01,o=.1,s=e.elements,c=s[0],l=s[4],u=s[8],d=s[1],f=s[5],p=s[9],m=s[2],h=s[6],g=s[10];if(Math.abs(l-d)<a&&Math.abs(u-m)<a&&Math.abs(p-h)<a){if(Math.abs(l+d)<o&&Math.abs(u+m)<o&&Math.abs(p+h)<o&&Math.abs(c+f+g-3)<o)return this.set(1,0,0,0),this;t=Math.PI;let e=(c+1)/2,s=(f+1)/2,_=(g+1)/2,v=(l+d)/4,y=(u+m)/4,b=(p+h)/4;return e>s&&e>_?e<a?(n=0,r=.707106781,i=.707106781):(n=Math.sqrt(e),r=v/n,i=y/n):s>_?s<a?(n=.707106781,r=0,i=.707106781):(r=Math.sqrt(s),n=v/r,i=b/r):_<a?(n=.707106781,r=.707106781,i=0):(i=Math.sqrt(_),n=y/i,r=b/i),this.set(n,r,i,t),this}let _=Math.sqrt((h-p)*(h-p)+(u-m)*(u-m)+(d-l)*(d-l));return Math.abs(_)<.001&&(_=1),this.x=(h-p)/_,this.y=(u-m)/_,this.z=(d-l)/_,this.w=Math.acos((c+f+g-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=en(this.x,e.x,t.x),this.y=en(this.y,e.y,t.y),this.z=en(this.z,e.z,t.z),this.w=en(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=en(this.x,e,t),this.y=en(this.y,e,t),this.z=en(this.z,e,t),this.w=en(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(en(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Un=class extends Jt{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:R,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new Hn(0,0,e,t),this.scissorTest=!1,this.viewport=new Hn(0,0,e,t),this.textures=[];let r=n.count;for(let i=0;i<r;i++)this.textures[i]=new Vn({width:e,height:t,depth:n.depth}),this.textures[i].isRenderTargetTexture=!0,this.textures[i].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:R,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let e=0;e<this.textures.length;e++)this.textures[e].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let r=0,i=this.textures.length;r<i;r++)this.textures[r].image.width=e,this.textures[r].image.height=t,this.textures[r].image.depth=n,this.textures[r].isData3DTexture!==!0&&(this.textures[r].isArrayTexture=this.textures[r].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let n=Object.assign({},e.textures[t].image);this.textures[t].source=new Ln(n)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null){if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture}else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:`dispose`})}},Wn=class extends Un{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},Gn=class extends Vn{constructor(e=null,t=1,n=1,r=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:r},this.magFilter=ve,this.minFilter=ve,this.wrapR=ge,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}},Kn=class extends Vn{constructor(e=null,t=1,n=1,r=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:r},this.magFilter=ve,this.minFilter=ve,this.wrapR=ge,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}},qn=class e{static{this.prototype.isMatrix4=!0}constructor(e,t,n,r,i,a,o,s,c,l,u,d,f,p,m,h){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,r,i,a,o,s,c,l,u,d,f,p,m,h)}set(e,t,n,r,i,a,o,s,c,l,u,d,f,p,m,h){let g=this.elements;return g[0]=e,g[4]=t,g[8]=n,g[12]=r,g[1]=i,g[5]=a,g[9]=o,g[13]=s,g[2]=c,g[6]=l,g[10]=u,g[14]=d,g[3]=f,g[7]=p,g[11]=m,g[15]=h,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new e().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,r=1/Jn.setFromMatrixColumn(e,0).length(),i=1/Jn.setFromMatrixColumn(e,1).length(),a=1/Jn.setFromMatrixColumn(e,2).length();return t[0]=n[0]*r,t[1]=n[1]*r,t[2]=n[2]*r,t[3]=0,t[4]=n[4]*i,t[5]=n[5]*i,t[6]=n[6]*i,t[7]=0,t[8]=n[8]*a,t[9]=n[9]*a,t[10]=n[10]*a,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,r=e.y,i=e.z,a=Math.cos(n),o=Math.sin(n),s=Math.cos(r),c=Math.sin(r),l=Math.cos(i),u=Math.sin(i);if(e.order===`XYZ`){let e=a*l,n=a*u,r=o*l,i=o*u;t[0]=s*l,t[4]=-s*u,t[8]=c,t[1]=n+r*c,t[5]=e-i*c,t[9]=-o*s,t[2]=i-e*c,t[6]=r+n*c,t[10]=a*s}else if(e.order===`YXZ`){let e=s*l,n=s*u,r=c*l,i=c*u;t[0]=e+i*o,t[4]=r*o-n,t[8]=a*c,t[1]=a*u,t[5]=a*l,t[9]=-o,t[2]=n*o-r,t[6]=i+e*o,t[10]=a*s}else if(e.order===`ZXY`){let e=s*l,n=s*u,r=c*l,i=c*u;t[0]=e-i*o,t[4]=-a*u,t[8]=r+n*o,t[1]=n+r*o,t[5]=a*l,t[9]=i-e*o,t[2]=-a*c,t[6]=o,t[10]=a*s}else if(e.order===`ZYX`){let e=a*l,n=a*u,r=o*l,i=o*u;t[0]=s*l,t[4]=r*c-n,t[8]=e*c+i,t[1]=s*u,t[5]=i*c+e,t[9]=n*c-r,t[2]=-c,t[6]=o*s,t[10]=a*s}else if(e.order===`YZX`){let e=a*s,n=a*c,r=o*s,i=o*c;t[0]=s*l,t[4]=i-e*u,t[8]=r*u+n,t[1]=u,t[5]=a*l,t[9]=-o*l,t[2]=-c*l,t[6]=n*u+r,t[10]=e-i*u}else if(e.order===`XZY`){let e=a*s,n=a*c,r=o*s,i=o*c;t[0]=s*l,t[4]=-u,t[8]=c*l,t[1]=e*u+i,t[5]=a*l,t[9]=n*u-r,t[2]=r*u-n,t[6]=o*l,t[10]=i*u+e}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(Xn,e,Zn)}lookAt(e,t,n){let r=this.elements;return er.subVectors(e,t),er.lengthSq()===0&&(er.z=1),er.normalize(),Qn.crossVectors(n,er),Qn.lengthSq()===0&&(Math.abs(n.z)===1?er.x+=1e-4:er.z+=1e-4,er.normalize(),Qn.crossVectors(n,er)),Qn.normalize(),$n.crossVectors(er,Qn),r[0]=Qn.x,r[4]=$n.x,r[8]=er.x,r[1]=Qn.y,r[5]=$n.y,r[9]=er.y,r[2]=Qn.z,r[6]=$n.z,r[10]=er.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,r=t.elements,i=this.elements,a=n[0],o=n[4],s=n[8],c=n[12],l=n[1],u=n[5],d=n[9],f=n[13],p=n[2],m=n[6],h=n[10],g=n[14],_=n[3],v=n[7],y=n[11],b=n[15],x=r[0],S=r[4],C=r[8],w=r[12],T=r[1],E=r[5],D=r[9],O=r[13],k=r[2],A=r[6],j=r[10],M=r[14],N=r[3],ee=r[7],te=r[11],ne=r[15];return i[0]=a*x+o*T+s*k+c*N,i[4]=a*S+o*E+s*A+c*ee,i[8]=a*C+o*D+s*j+c*te,i[12]=a*w+o*O+s*M+c*ne,i[1]=l*x+u*T+d*k+f*N,i[5]=l*S+u*E+d*A+f*ee,i[9]=l*C+u*D+d*j+f*te,i[13]=l*w+u*O+d*M+f*ne,i[2]=p*x+m*T+h*k+g*N,i[6]=p*S+m*E+h*A+g*ee,i[10]=p*C+m*D+h*j+g*te,i[14]=p*w+m*O+h*M+g*ne,i[3]=_*x+v*T+y*k+b*N,i[7]=_*S+v*E+y*A+b*ee,i[11]=_*C+v*D+y*j+b*te,i[15]=_*w+v*O+y*M+b*ne,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],r=e[8],i=e[12],a=e[1],o=e[5],s=e[9],c=e[13],l=e[2],u=e[6],d=e[10],f=e[14],p=e[3],m=e[7],h=e[11],g=e[15],_=s*f-c*d,v=o*f-c*u,y=o*d-s*u,b=a*f-c*l,x=a*d-s*l,S=a*u-o*l;return t*(m*_-h*v+g*y)-n*(p*_-h*b+g*x)+r*(p*v-m*b+g*S)-i*(p*y-m*x+h*S)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],r=e[8],i=e[1],a=e[5],o=e[9],s=e[2],c=e[6],l=e[10];return t*(a*l-o*c)-n*(i*l-o*s)+r*(i*c-a*s)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let r=this.elements;return e.isVector3?(r[12]=e.x,r[13]=e.y,r[14]=e.z):(r[12]=e,r[13]=t,r[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],r=e[2],i=e[3],a=e[4],o=e[5],s=e[6],c=e[7],l=e[8],u=e[9],d=e[10],f=e[11],p=e[12],m=e[13],h=e[14],g=e[15],_=t*o-n*a,v=t*s-r*a,y=t*c-i*a,b=n*s-r*o,x=n*c-i*o,S=r*c-i*s,C=l*m-u*p,w=l*h-d*p,T=l*g-f*p,E=u*h-d*m,D=u*g-f*m,O=d*g-f*h,k=_*O-v*D+y*E+b*T-x*w+S*C;if(k===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let A=1/k;return e[0]=(o*O-s*D+c*E)*A,e[1]=(r*D-n*O-i*E)*A,e[2]=(m*S-h*x+g*b)*A,e[3]=(d*x-u*S-f*b)*A,e[4]=(s*T-a*O-c*w)*A,e[5]=(t*O-r*T+i*w)*A,e[6]=(h*y-p*S-g*v)*A,e[7]=(l*S-d*y+f*v)*A,e[8]=(a*D-o*T+c*C)*A,e[9]=(n*T-t*D-i*C)*A,e[10]=(p*x-m*y+g*_)*A,e[11]=(u*y-l*x-f*_)*A,e[12]=(o*w-a*E-s*C)*A,e[13]=(t*E-n*w+r*C)*A,e[14]=(m*v-p*b-h*_)*A,e[15]=(l*b-u*v+d*_)*A,this}scale(e){let t=this.elements,n=e.x,r=e.y,i=e.z;return t[0]*=n,t[4]*=r,t[8]*=i,t[1]*=n,t[5]*=r,t[9]*=i,t[2]*=n,t[6]*=r,t[10]*=i,t[3]*=n,t[7]*=r,t[11]*=i,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],r=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,r))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),r=Math.sin(t),i=1-n,a=e.x,o=e.y,s=e.z,c=i*a,l=i*o;return this.set(c*a+n,c*o-r*s,c*s+r*o,0,c*o+r*s,l*o+n,l*s-r*a,0,c*s-r*o,l*s+r*a,i*s*s+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,r,i,a){return this.set(1,n,i,0,e,1,a,0,t,r,1,0,0,0,0,1),this}compose(e,t,n){let r=this.elements,i=t._x,a=t._y,o=t._z,s=t._w,c=i+i,l=a+a,u=o+o,d=i*c,f=i*l,p=i*u,m=a*l,h=a*u,g=o*u,_=s*c,v=s*l,y=s*u,b=n.x,x=n.y,S=n.z;return r[0]=(1-(m+g))*b,r[1]=(f+y)*b,r[2]=(p-v)*b,r[3]=0,r[4]=(f-y)*x,r[5]=(1-(d+g))*x,r[6]=(h+_)*x,r[7]=0,r[8]=(p+v)*S,r[9]=(h-_)*S,r[10]=(1-(d+m))*S,r[11]=0,r[12]=e.x,r[13]=e.y,r[14]=e.z,r[15]=1,this}decompose(e,t,n){let r=this.elements;e.x=r[12],e.y=r[13],e.z=r[14];let i=this.determinantAffine();if(i===0)return n.set(1,1,1),t.identity(),this;let a=Jn.set(r[0],r[1],r[2]).length(),o=Jn.set(r[4],r[5],r[6]).length(),s=Jn.set(r[8],r[9],r[10]).length();i<0&&(a=-a),Yn.copy(this);let c=1/a,l=1/o,u=1/s;return Yn.elements[0]*=c,Yn.elements[1]*=c,Yn.elements[2]*=c,Yn.elements[4]*=l,Yn.elements[5]*=l,Yn.elements[6]*=l,Yn.elements[8]*=u,Yn.elements[9]*=u,Yn.elements[10]*=u,t.setFromRotationMatrix(Yn),n.x=a,n.y=o,n.z=s,this}makePerspective(e,t,n,r,i,a,o=Lt,s=!1){let c=this.elements,l=2*i/(t-e),u=2*i/(n-r),d=(t+e)/(t-e),f=(n+r)/(n-r),p,m;if(s)p=i/(a-i),m=a*i/(a-i);else if(o===2e3)p=-(a+i)/(a-i),m=-2*a*i/(a-i);else if(o===2001)p=-a/(a-i),m=-a*i/(a-i);else throw Error(`THREE.Matrix4.makePerspective(): Invalid coordinate system: `+o);return c[0]=l,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=u,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=m,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,r,i,a,o=Lt,s=!1){let c=this.elements,l=2/(t-e),u=2/(n-r),d=-(t+e)/(t-e),f=-(n+r)/(n-r),p,m;if(s)p=1/(a-i),m=a/(a-i);else if(o===2e3)p=-2/(a-i),m=-(a+i)/(a-i);else if(o===2001)p=-1/(a-i),m=-i/(a-i);else throw Error(`THREE.Matrix4.makeOrthographic(): Invalid coordinate system: `+o);return c[0]=l,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=u,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=m,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let e=0;e<16;e++)if(t[e]!==n[e])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},Jn=new J,Yn=new qn,Xn=new J(0,0,0),Zn=new J(1,1,1),Qn=new J,$n=new J,er=new J,tr=new qn,nr=new wn,rr=class e{constructor(t=0,n=0,r=0,i=e.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=n,this._z=r,this._order=i}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,r=this._order){return this._x=e,this._y=t,this._z=n,this._order=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let r=e.elements,i=r[0],a=r[4],o=r[8],s=r[1],c=r[5],l=r[9],u=r[2],d=r[6],f=r[10];switch(t){case`XYZ`:this._y=Math.asin(en(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(-l,f),this._z=Math.atan2(-a,i)):(this._x=Math.atan2(d,c),this._z=0);break;case`YXZ`:this._x=Math.asin(-en(l,-1,1)),Math.abs(l)<.9999999?(this._y=Math.atan2(o,f),this._z=Math.atan2(s,c)):(this._y=Math.atan2(-u,i),this._z=0);break;case`ZXY`:this._x=Math.asin(en(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-a,c)):(this._y=0,this._z=Math.atan2(s,i));break;case`ZYX`:this._y=Math.asin(-en(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(s,i)):(this._x=0,this._z=Math.atan2(-a,c));break;case`YZX`:this._z=Math.asin(en(s,-1,1)),Math.abs(s)<.9999999?(this._x=Math.atan2(-l,c),this._y=Math.atan2(-u,i)):(this._x=0,this._y=Math.atan2(o,f));break;case`XZY`:this._z=Math.asin(-en(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(o,i)):(this._x=Math.atan2(-l,f),this._y=0);break;default:G(`Euler: .setFromRotationMatrix() encountered an unknown order: `+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return tr.makeRotationFromQuaternion(e),this.setFromRotationMatrix(tr,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return nr.setFromEuler(this),this.setFromQuaternion(nr,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};rr.DEFAULT_ORDER=`XYZ`;var ir=class{constructor(){this.mask=1}set(e){this.mask=1<<e>>>0}enable(e){this.mask|=1<<e}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e}disable(e){this.mask&=~(1<<e)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return!!(this.mask&1<<e)}},ar=0,or=new J,sr=new wn,cr=new qn,lr=new J,ur=new J,dr=new J,fr=new wn,pr=new J(1,0,0),mr=new J(0,1,0),hr=new J(0,0,1),gr={type:`added`},_r={type:`removed`},vr={type:`childadded`,child:null},yr={type:`childremoved`,child:null},br=class e extends Jt{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:ar++}),this.uuid=$t(),this.name=``,this.type=`Object3D`,this.parent=null,this.children=[],this.up=e.DEFAULT_UP.clone();let t=new J,n=new rr,r=new wn,i=new J(1,1,1);function a(){r.setFromEuler(n,!1)}function o(){n.setFromQuaternion(r,void 0,!1)}n._onChange(a),r._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:n},quaternion:{configurable:!0,enumerable:!0,value:r},scale:{configurable:!0,enumerable:!0,value:i},modelViewMatrix:{value:new qn},normalMatrix:{value:new Y}}),this.matrix=new qn,this.matrixWorld=new qn,this.matrixAutoUpdate=e.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=e.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ir,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return sr.setFromAxisAngle(e,t),this.quaternion.multiply(sr),this}rotateOnWorldAxis(e,t){return sr.setFromAxisAngle(e,t),this.quaternion.premultiply(sr),this}rotateX(e){return this.rotateOnAxis(pr,e)}rotateY(e){return this.rotateOnAxis(mr,e)}rotateZ(e){return this.rotateOnAxis(hr,e)}translateOnAxis(e,t){return or.copy(e).applyQuaternion(this.quaternion),this.position.add(or.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(pr,e)}translateY(e){return this.translateOnAxis(mr,e)}translateZ(e){return this.translateOnAxis(hr,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(cr.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?lr.copy(e):lr.set(e,t,n);let r=this.parent;this.updateWorldMatrix(!0,!1),ur.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?cr.lookAt(ur,lr,this.up):cr.lookAt(lr,ur,this.up),this.quaternion.setFromRotationMatrix(cr),r&&(cr.extractRotation(r.matrixWorld),sr.setFromRotationMatrix(cr),this.quaternion.premultiply(sr.invert()))}add(e){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return e===this?(K(`Object3D.add: object can't be added as a child of itself.`,e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(gr),vr.child=e,this.dispatchEvent(vr),vr.child=null):K(`Object3D.add: object not an instance of THREE.Object3D.`,e),this)}remove(e){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.remove(arguments[e]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(_r),yr.child=e,this.dispatchEvent(yr),yr.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),cr.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),cr.multiply(e.parent.matrixWorld)),e.applyMatrix4(cr),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(gr),vr.child=e,this.dispatchEvent(vr),vr.child=null,this}getObjectById(e){return this.getObjectByProperty(`id`,e)}getObjectByName(e){return this.getObjectByProperty(`name`,e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,r=this.children.length;n<r;n++){let r=this.children[n].getObjectByProperty(e,t);if(r!==void 0)return r}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let r=this.children;for(let i=0,a=r.length;i<a;i++)r[i].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ur,e,dr),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ur,fr,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,r=t.length;n<r;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,r=t.length;n<r;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,r=e.z,i=this.matrix.elements;i[12]+=t-i[0]*t-i[4]*n-i[8]*r,i[13]+=n-i[1]*t-i[5]*n-i[9]*r,i[14]+=r-i[2]*t-i[6]*n-i[10]*r}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,r=t.length;n<r;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let r=this.parent;if(e===!0&&r!==null&&r.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let e=this.children;for(let t=0,r=e.length;t<r;t++)e[t].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e==`string`,n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:`Object`,generator:`Object3D.toJSON`});let r={};r.uuid=this.uuid,r.type=this.type,r.name=this.name,r.castShadow=this.castShadow,r.receiveShadow=this.receiveShadow,r.visible=this.visible,r.frustumCulled=this.frustumCulled,r.renderOrder=this.renderOrder,r.static=this.static,r.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(r.userData=this.userData),r.layers=this.layers.mask,r.matrix=this.matrix.toArray(),r.up=this.up.toArray(),this.pivot!==null&&(r.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(r.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(r.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(r.type=`InstancedMesh`,r.count=this.count,r.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(r.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(r.type=`BatchedMesh`,r.perObjectFrustumCulled=this.perObjectFrustumCulled,r.sortObjects=this.sortObjects,r.drawRanges=this._drawRanges,r.reservedRanges=this._reservedRanges,r.geometryInfo=this._geometryInfo.map(e=>({...e,boundingBox:e.boundingBox?e.boundingBox.toJSON():void 0,boundingSphere:e.boundingSphere?e.boundingSphere.toJSON():void 0})),r.instanceInfo=this._instanceInfo.map(e=>({...e})),r.availableInstanceIds=this._availableInstanceIds.slice(),r.availableGeometryIds=this._availableGeometryIds.slice(),r.nextIndexStart=this._nextIndexStart,r.nextVertexStart=this._nextVertexStart,r.geometryCount=this._geometryCount,r.maxInstanceCount=this._maxInstanceCount,r.maxVertexCount=this._maxVertexCount,r.maxIndexCount=this._maxIndexCount,r.geometryInitialized=this._geometryInitialized,r.matricesTexture=this._matricesTexture.toJSON(e),r.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(r.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(r.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(r.boundingBox=this.boundingBox.toJSON()));function i(t,n){return t[n.uuid]===void 0&&(t[n.uuid]=n.toJSON(e)),n.uuid}if(this.isScene)this.background&&(this.background.isColor?r.background=this.background.toJSON():this.background.isTexture&&(r.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(r.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){r.geometry=i(e.geometries,this.geometry);let t=this.geometry.parameters;if(t!==void 0&&t.shapes!==void 0){let n=t.shapes;if(Array.isArray(n))for(let t=0,r=n.length;t<r;t++){let r=n[t];i(e.shapes,r)}else i(e.shapes,n)}}if(this.isSkinnedMesh&&(r.bindMode=this.bindMode,r.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(i(e.skeletons,this.skeleton),r.skeleton=this.skeleton.uuid)),this.material!==void 0){if(Array.isArray(this.material)){let t=[];for(let n=0,r=this.material.length;n<r;n++)t.push(i(e.materials,this.material[n]));r.material=t}else r.material=i(e.materials,this.material)}if(this.children.length>0){r.children=[];for(let t=0;t<this.children.length;t++)r.children.push(this.children[t].toJSON(e).object)}if(this.animations.length>0){r.animations=[];for(let t=0;t<this.animations.length;t++){let n=this.animations[t];r.animations.push(i(e.animations,n))}}if(t){let t=a(e.geometries),r=a(e.materials),i=a(e.textures),o=a(e.images),s=a(e.shapes),c=a(e.skeletons),l=a(e.animations),u=a(e.nodes);t.length>0&&(n.geometries=t),r.length>0&&(n.materials=r),i.length>0&&(n.textures=i),o.length>0&&(n.images=o),s.length>0&&(n.shapes=s),c.length>0&&(n.skeletons=c),l.length>0&&(n.animations=l),u.length>0&&(n.nodes=u)}return n.object=r,n;function a(e){let t=[];for(let n in e){let r=e[n];delete r.metadata,t.push(r)}return t}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot===null?null:e.pivot.clone(),this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let t=0;t<e.children.length;t++){let n=e.children[t];this.add(n.clone())}return this}dispose(){this.dispatchEvent({type:`dispose`})}};br.DEFAULT_UP=new J(0,1,0),br.DEFAULT_MATRIX_AUTO_UPDATE=!0,br.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var xr=class extends br{constructor(){super(),this.isGroup=!0,this.type=`Group`}},Sr={type:`move`},Cr=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new xr,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new xr,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new J,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new J),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new xr,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new J,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new J,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:`connected`,data:e}),this}disconnect(e){return this.dispatchEvent({type:`disconnected`,data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let r=null,i=null,a=null,o=this._targetRay,s=this._grip,c=this._hand;if(e&&t.session.visibilityState!==`visible-blurred`){if(c&&e.hand){a=!0;for(let r of e.hand.values()){let e=t.getJointPose(r,n),i=this._getHandJoint(c,r);e!==null&&(i.matrix.fromArray(e.transform.matrix),i.matrix.decompose(i.position,i.quaternion,i.scale),i.matrixWorldNeedsUpdate=!0,i.jointRadius=e.radius),i.visible=e!==null}let r=c.joints[`index-finger-tip`],i=c.joints[`thumb-tip`],o=r.position.distanceTo(i.position);c.inputState.pinching&&o>.025?(c.inputState.pinching=!1,this.dispatchEvent({type:`pinchend`,handedness:e.handedness,target:this})):!c.inputState.pinching&&o<=.015&&(c.inputState.pinching=!0,this.dispatchEvent({type:`pinchstart`,handedness:e.handedness,target:this}))}else s!==null&&e.gripSpace&&(i=t.getPose(e.gripSpace,n),i!==null&&(s.matrix.fromArray(i.transform.matrix),s.matrix.decompose(s.position,s.quaternion,s.scale),s.matrixWorldNeedsUpdate=!0,i.linearVelocity?(s.hasLinearVelocity=!0,s.linearVelocity.copy(i.linearVelocity)):s.hasLinearVelocity=!1,i.angularVelocity?(s.hasAngularVelocity=!0,s.angularVelocity.copy(i.angularVelocity)):s.hasAngularVelocity=!1,s.eventsEnabled&&s.dispatchEvent({type:`gripUpdated`,data:e,target:this})));o!==null&&(r=t.getPose(e.targetRaySpace,n),r===null&&i!==null&&(r=i),r!==null&&(o.matrix.fromArray(r.transform.matrix),o.matrix.decompose(o.position,o.quaternion,o.scale),o.matrixWorldNeedsUpdate=!0,r.linearVelocity?(o.hasLinearVelocity=!0,o.linearVelocity.copy(r.linearVelocity)):o.hasLinearVelocity=!1,r.angularVelocity?(o.hasAngularVelocity=!0,o.angularVelocity.copy(r.angularVelocity)):o.hasAngularVelocity=!1,this.dispatchEvent(Sr)))}return o!==null&&(o.visible=r!==null),s!==null&&(s.visible=i!==null),c!==null&&(c.visible=a!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new xr;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},wr={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Tr={h:0,s:0,l:0},Er={h:0,s:0,l:0};function Dr(e,t,n){return n<0&&(n+=1),n>1&&--n,n<1/6?e+(t-e)*6*n:n<1/2?t:n<2/3?e+(t-e)*6*(2/3-n):e}var Or=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let t=e;t&&t.isColor?this.copy(t):typeof t==`number`?this.setHex(t):typeof t==`string`&&this.setStyle(t)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=At){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,jn.colorSpaceToWorking(this,t),this}setRGB(e,t,n,r=jn.workingColorSpace){return this.r=e,this.g=t,this.b=n,jn.colorSpaceToWorking(this,r),this}setHSL(e,t,n,r=jn.workingColorSpace){if(e=tn(e,1),t=en(t,0,1),n=en(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,i=2*n-r;this.r=Dr(i,r,e+1/3),this.g=Dr(i,r,e),this.b=Dr(i,r,e-1/3)}return jn.colorSpaceToWorking(this,r),this}setStyle(e,t=At){function n(t){t!==void 0&&parseFloat(t)<1&&G(`Color: Alpha component of `+e+` will be ignored.`)}let r;if(r=/^(\w+)\(([^\)]*)\)/.exec(e)){let i,a=r[1],o=r[2];switch(a){case`rgb`:case`rgba`:if(i=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(i[4]),this.setRGB(Math.min(255,parseInt(i[1],10))/255,Math.min(255,parseInt(i[2],10))/255,Math.min(255,parseInt(i[3],10))/255,t);if(i=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(i[4]),this.setRGB(Math.min(100,parseFloat(i[1]))/100,Math.min(100,parseFloat(i[2]))/100,Math.min(100,parseFloat(i[3]))/100,t);break;case`hsl`:case`hsla`:if(i=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(i[4]),this.setHSL(parseFloat(i[1])/360,parseFloat(i[2])/100,parseFloat(i[3])/100,t);break;default:G(`Color: Unknown color model `+e)}}else if(r=/^\#([A-Fa-f\d]+)$/.exec(e)){let n=r[1],i=n.length;if(i===3)return this.setRGB(parseInt(n.charAt(0),16)/15,parseInt(n.charAt(1),16)/15,parseInt(n.charAt(2),16)/15,t);if(i===6)return this.setHex(parseInt(n,16),t);G(`Color: Invalid hex color `+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=At){let n=wr[e.toLowerCase()];return n===void 0?G(`Color: Unknown color `+e):this.setHex(n,t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Mn(e.r),this.g=Mn(e.g),this.b=Mn(e.b),this}copyLinearToSRGB(e){return this.r=Nn(e.r),this.g=Nn(e.g),this.b=Nn(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=At){return jn.workingToColorSpace(kr.copy(this),e),Math.round(en(kr.r*255,0,255))*65536+Math.round(en(kr.g*255,0,255))*256+Math.round(en(kr.b*255,0,255))}getHexString(e=At){return(`000000`+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=jn.workingColorSpace){jn.workingToColorSpace(kr.copy(this),t);let n=kr.r,r=kr.g,i=kr.b,a=Math.max(n,r,i),o=Math.min(n,r,i),s,c,l=(o+a)/2;if(o===a)s=0,c=0;else{let e=a-o;switch(c=l<=.5?e/(a+o):e/(2-a-o),a){case n:s=(r-i)/e+(r<i?6:0);break;case r:s=(i-n)/e+2;break;case i:s=(n-r)/e+4}s/=6}return e.h=s,e.s=c,e.l=l,e}getRGB(e,t=jn.workingColorSpace){return jn.workingToColorSpace(kr.copy(this),t),e.r=kr.r,e.g=kr.g,e.b=kr.b,e}getStyle(e=At){jn.workingToColorSpace(kr.copy(this),e);let t=kr.r,n=kr.g,r=kr.b;return e===`srgb`?`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(r*255)})`:`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${r.toFixed(3)})`}offsetHSL(e,t,n){return this.getHSL(Tr),this.setHSL(Tr.h+e,Tr.s+t,Tr.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Tr),e.getHSL(Er);let n=an(Tr.h,Er.h,t),r=an(Tr.s,Er.s,t),i=an(Tr.l,Er.l,t);return this.setHSL(n,r,i),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,r=this.b,i=e.elements;return this.r=i[0]*t+i[3]*n+i[6]*r,this.g=i[1]*t+i[4]*n+i[7]*r,this.b=i[2]*t+i[5]*n+i[8]*r,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},kr=new Or;Or.NAMES=wr;var Ar=class extends br{constructor(){super(),this.isScene=!0,this.type=`Scene`,this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new rr,this.environmentIntensity=1,this.environmentRotation=new rr,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<`u`&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent(`observe`,{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background===null?null:e.background.clone(),this.environment=e.environment===null?null:e.environment.clone(),this.fog=e.fog===null?null:e.fog.clone(),this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial===null?null:e.overrideMaterial.clone(),this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},jr=new J,Mr=new J,Nr=new J,Pr=new J,Fr=new J,Ir=new J,Lr=new J,Rr=new J,zr=new J,Br=new J,Vr=new Hn,Hr=new Hn,Ur=new Hn,Wr=class e{constructor(e=new J,t=new J,n=new J){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,r){r.subVectors(n,t),jr.subVectors(e,t),r.cross(jr);let i=r.lengthSq();return i>0?r.multiplyScalar(1/Math.sqrt(i)):r.set(0,0,0)}static getBarycoord(e,t,n,r,i){jr.subVectors(r,t),Mr.subVectors(n,t),Nr.subVectors(e,t);let a=jr.dot(jr),o=jr.dot(Mr),s=jr.dot(Nr),c=Mr.dot(Mr),l=Mr.dot(Nr),u=a*c-o*o;if(u===0)return i.set(0,0,0),null;let d=1/u,f=(c*s-o*l)*d,p=(a*l-o*s)*d;return i.set(1-f-p,p,f)}static containsPoint(e,t,n,r){return this.getBarycoord(e,t,n,r,Pr)!==null&&Pr.x>=0&&Pr.y>=0&&Pr.x+Pr.y<=1}static getInterpolation(e,t,n,r,i,a,o,s){return this.getBarycoord(e,t,n,r,Pr)===null?(s.x=0,s.y=0,`z`in s&&(s.z=0),`w`in s&&(s.w=0),null):(s.setScalar(0),s.addScaledVector(i,Pr.x),s.addScaledVector(a,Pr.y),s.addScaledVector(o,Pr.z),s)}static getInterpolatedAttribute(e,t,n,r,i,a){return Vr.setScalar(0),Hr.setScalar(0),Ur.setScalar(0),Vr.fromBufferAttribute(e,t),Hr.fromBufferAttribute(e,n),Ur.fromBufferAttribute(e,r),a.setScalar(0),a.addScaledVector(Vr,i.x),a.addScaledVector(Hr,i.y),a.addScaledVector(Ur,i.z),a}static isFrontFacing(e,t,n,r){return jr.subVectors(n,t),Mr.subVectors(e,t),jr.cross(Mr).dot(r)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,r){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[r]),this}setFromAttributeAndIndices(e,t,n,r){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,r),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return jr.subVectors(this.c,this.b),Mr.subVectors(this.a,this.b),jr.cross(Mr).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return e.getNormal(this.a,this.b,this.c,t)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,n){return e.getBarycoord(t,this.a,this.b,this.c,n)}getInterpolation(t,n,r,i,a){return e.getInterpolation(t,this.a,this.b,this.c,n,r,i,a)}containsPoint(t){return e.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return e.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,r=this.b,i=this.c,a,o;Fr.subVectors(r,n),Ir.subVectors(i,n),Rr.subVectors(e,n);let s=Fr.dot(Rr),c=Ir.dot(Rr);if(s<=0&&c<=0)return t.copy(n);zr.subVectors(e,r);let l=Fr.dot(zr),u=Ir.dot(zr);if(l>=0&&u<=l)return t.copy(r);let d=s*u-l*c;if(d<=0&&s>=0&&l<=0&&s-l>0)return a=s/(s-l),t.copy(n).addScaledVector(Fr,a);Br.subVectors(e,i);let f=Fr.dot(Br),p=Ir.dot(Br);if(p>=0&&f<=p)return t.copy(i);let m=f*c-s*p;if(m<=0&&c>=0&&p<=0)return o=c/(c-p),t.copy(n).addScaledVector(Ir,o);let h=l*p-f*u;if(h<=0&&u-l>=0&&f-p>=0)return Lr.subVectors(i,r),o=(u-l)/(u-l+(f-p)),t.copy(r).addScaledVector(Lr,o);let g=1/(h+m+d);return a=m*g,o=d*g,t.copy(n).addScaledVector(Fr,a).addScaledVector(Ir,o)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Gr=class{constructor(e=new J(1/0,1/0,1/0),t=new J(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(qr.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(qr.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=qr.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute(`position`);if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let t=0,n=r.count;t<n;t++)e.isMesh===!0?e.getVertexPosition(t,qr):qr.fromBufferAttribute(r,t),qr.applyMatrix4(e.matrixWorld),this.expandByPoint(qr);else e.boundingBox===void 0?(n.boundingBox===null&&n.computeBoundingBox(),Jr.copy(n.boundingBox)):(e.boundingBox===null&&e.computeBoundingBox(),Jr.copy(e.boundingBox)),Jr.applyMatrix4(e.matrixWorld),this.union(Jr)}let r=e.children;for(let e=0,n=r.length;e<n;e++)this.expandByObject(r[e],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,qr),qr.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(ti),ni.subVectors(this.max,ti),Yr.subVectors(e.a,ti),Xr.subVectors(e.b,ti),Zr.subVectors(e.c,ti),Qr.subVectors(Xr,Yr),$r.subVectors(Zr,Xr),ei.subVectors(Yr,Zr);let t=[0,-Qr.z,Qr.y,0,-$r.z,$r.y,0,-ei.z,ei.y,Qr.z,0,-Qr.x,$r.z,0,-$r.x,ei.z,0,-ei.x,-Qr.y,Qr.x,0,-$r.y,$r.x,0,-ei.y,ei.x,0];return!ai(t,Yr,Xr,Zr,ni)||(t=[1,0,0,0,1,0,0,0,1],!ai(t,Yr,Xr,Zr,ni))?!1:(ri.crossVectors(Qr,$r),t=[ri.x,ri.y,ri.z],ai(t,Yr,Xr,Zr,ni))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,qr).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(qr).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()||(Kr[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Kr[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Kr[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Kr[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Kr[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Kr[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Kr[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Kr[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Kr)),this}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Kr=[new J,new J,new J,new J,new J,new J,new J,new J],qr=new J,Jr=new Gr,Yr=new J,Xr=new J,Zr=new J,Qr=new J,$r=new J,ei=new J,ti=new J,ni=new J,ri=new J,ii=new J;function ai(e,t,n,r,i){for(let a=0,o=e.length-3;a<=o;a+=3){ii.fromArray(e,a);let o=i.x*Math.abs(ii.x)+i.y*Math.abs(ii.y)+i.z*Math.abs(ii.z),s=t.dot(ii),c=n.dot(ii),l=r.dot(ii);if(Math.max(-Math.max(s,c,l),Math.min(s,c,l))>o)return!1}return!0}var oi=new J,si=new q,ci=0,li=class extends Jt{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw TypeError(`THREE.BufferAttribute: array should be a Typed Array.`);this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:ci++}),this.name=``,this.array=e,this.itemSize=t,this.count=e===void 0?0:e.length/t,this.normalized=n,this.usage=Ft,this.updateRanges=[],this.gpuType=Te,this.version=0,this._normalizationScale=e===void 0?void 0:bn(e)}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let r=0,i=this.itemSize;r<i;r++)this.array[e+r]=t.array[n+r];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)si.fromBufferAttribute(this,t),si.applyMatrix3(e),this.setXY(t,si.x,si.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)oi.fromBufferAttribute(this,t),oi.applyMatrix3(e),this.setXYZ(t,oi.x,oi.y,oi.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)oi.fromBufferAttribute(this,t),oi.applyMatrix4(e),this.setXYZ(t,oi.x,oi.y,oi.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)oi.fromBufferAttribute(this,t),oi.applyNormalMatrix(e),this.setXYZ(t,oi.x,oi.y,oi.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)oi.fromBufferAttribute(this,t),oi.transformDirection(e),this.setXYZ(t,oi.x,oi.y,oi.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=r,this}setXYZW(e,t,n,r,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),r=this._normalize(r),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=r,this.array[e+3]=i,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:`dispose`})}_denormalize(e){let t=this._normalizationScale;return t===void 0?xn(e,this.array):Math.max(e/t,-1)}_normalize(e){let t=this._normalizationScale;return t===void 0?Sn(e,this.array):Math.round(e*t)}},ui=class extends li{constructor(e,t,n){super(new Uint16Array(e),t,n)}},di=class extends li{constructor(e,t,n){super(new Uint32Array(e),t,n)}},fi=class extends li{constructor(e,t,n){super(new Float32Array(e),t,n)}},pi=new Gr,mi=new J,hi=new J,gi=class{constructor(e=new J,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t===void 0?pi.setFromPoints(e).getCenter(n):n.copy(t);let r=0;for(let t=0,i=e.length;t<i;t++)r=Math.max(r,n.distanceToSquared(e[t]));return this.radius=Math.sqrt(r),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius*=e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;mi.subVectors(e,this.center);let t=mi.lengthSq();if(t>this.radius*this.radius){let e=Math.sqrt(t),n=(e-this.radius)*.5;this.center.addScaledVector(mi,n/e),this.radius+=n}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(hi.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(mi.copy(e.center).add(hi)),this.expandByPoint(mi.copy(e.center).sub(hi))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},_i=0,vi=new qn,yi=new br,bi=new J,xi=new Gr,Si=new Gr,Ci=new J,wi=class e extends Jt{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:_i++}),this.uuid=$t(),this.name=``,this.type=`BufferGeometry`,this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return this.index=Array.isArray(e)?new(Rt(e)?di:ui)(e,1):e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let t=new Y().getNormalMatrix(e);n.applyNormalMatrix(t),n.needsUpdate=!0}let r=this.attributes.tangent;return r!==void 0&&(r.transformDirection(e),r.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return vi.makeRotationFromQuaternion(e),this.applyMatrix4(vi),this}rotateX(e){return vi.makeRotationX(e),this.applyMatrix4(vi),this}rotateY(e){return vi.makeRotationY(e),this.applyMatrix4(vi),this}rotateZ(e){return vi.makeRotationZ(e),this.applyMatrix4(vi),this}translate(e,t,n){return vi.makeTranslation(e,t,n),this.applyMatrix4(vi),this}scale(e,t,n){return vi.makeScale(e,t,n),this.applyMatrix4(vi),this}lookAt(e){return yi.lookAt(e),yi.updateMatrix(),this.applyMatrix4(yi.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(bi).negate(),this.translate(bi.x,bi.y,bi.z),this}setFromPoints(e){let t=this.getAttribute(`position`);if(t===void 0){let t=[];for(let n=0,r=e.length;n<r;n++){let r=e[n];t.push(r.x,r.y,r.z||0)}this.setAttribute(`position`,new fi(t,3))}else{let n=Math.min(e.length,t.count);for(let r=0;r<n;r++){let n=e[r];t.setXYZ(r,n.x,n.y,n.z||0)}e.length>t.count&&G(`BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry.`),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Gr);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute)K(`BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.`,this),this.boundingBox.set(new J(-1/0,-1/0,-1/0),new J(1/0,1/0,1/0));else{if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let e=0,n=t.length;e<n;e++){let n=t[e];xi.setFromBufferAttribute(n),this.morphTargetsRelative?(Ci.addVectors(this.boundingBox.min,xi.min),this.boundingBox.expandByPoint(Ci),Ci.addVectors(this.boundingBox.max,xi.max),this.boundingBox.expandByPoint(Ci)):(this.boundingBox.expandByPoint(xi.min),this.boundingBox.expandByPoint(xi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&K(`BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.`,this)}}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new gi);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute)K(`BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.`,this),this.boundingSphere.set(new J,1/0);else if(e){let n=this.boundingSphere.center;if(xi.setFromBufferAttribute(e),t)for(let e=0,n=t.length;e<n;e++){let n=t[e];Si.setFromBufferAttribute(n),this.morphTargetsRelative?(Ci.addVectors(xi.min,Si.min),xi.expandByPoint(Ci),Ci.addVectors(xi.max,Si.max),xi.expandByPoint(Ci)):(xi.expandByPoint(Si.min),xi.expandByPoint(Si.max))}xi.getCenter(n);let r=0;for(let t=0,i=e.count;t<i;t++)Ci.fromBufferAttribute(e,t),r=Math.max(r,n.distanceToSquared(Ci));if(t)for(let i=0,a=t.length;i<a;i++){let a=t[i],o=this.morphTargetsRelative;for(let t=0,i=a.count;t<i;t++)Ci.fromBufferAttribute(a,t),o&&(bi.fromBufferAttribute(e,t),Ci.add(bi)),r=Math.max(r,n.distanceToSquared(Ci))}this.boundingSphere.radius=Math.sqrt(r),isNaN(this.boundingSphere.radius)&&K(`BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.`,this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){K(`BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)`);return}let n=t.position,r=t.normal,i=t.uv,a=this.getAttribute(`tangent`);(a===void 0||a.count!==n.count)&&(a=new li(new Float32Array(4*n.count),4),this.setAttribute(`tangent`,a));let o=[],s=[],c=new Uint8Array(n.count);for(let e=0;e<n.count;e++)o[e]=new J,s[e]=new J;let l=new J,u=new J,d=new J,f=new q,p=new q,m=new q,h=new J,g=new J;function _(e,t,r){c[e]=c[t]=c[r]=1,l.fromBufferAttribute(n,e),u.fromBufferAttribute(n,t),d.fromBufferAttribute(n,r),f.fromBufferAttribute(i,e),p.fromBufferAttribute(i,t),m.fromBufferAttribute(i,r),u.sub(l),d.sub(l),p.sub(f),m.sub(f);let a=1/(p.x*m.y-m.x*p.y);isFinite(a)&&(h.copy(u).multiplyScalar(m.y).addScaledVector(d,-p.y).multiplyScalar(a),g.copy(d).multiplyScalar(p.x).addScaledVector(u,-m.x).multiplyScalar(a),o[e].add(h),o[t].add(h),o[r].add(h),s[e].add(g),s[t].add(g),s[r].add(g))}let v=this.groups;v.length===0&&(v=[{start:0,count:e.count}]);for(let t=0,n=v.length;t<n;++t){let n=v[t],r=n.start,i=n.count;for(let t=r,n=r+i;t<n;t+=3)_(e.getX(t+0),e.getX(t+1),e.getX(t+2))}let y=new J,b=new J,x=new J,S=new J;function C(e){x.fromBufferAttribute(r,e),S.copy(x);let t=o[e];y.copy(t),y.sub(x.multiplyScalar(x.dot(t))).normalize(),b.crossVectors(S,t);let n=b.dot(s[e])<0?-1:1;a.setXYZW(e,y.x,y.y,y.z,n)}for(let e=0,t=n.count;e<t;++e)c[e]&&C(e);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute(`position`);if(t!==void 0){let n=this.getAttribute(`normal`);if(n===void 0||n.count!==t.count)n=new li(new Float32Array(t.count*3),3),this.setAttribute(`normal`,n);else for(let e=0,t=n.count;e<t;e++)n.setXYZ(e,0,0,0);let r=new J,i=new J,a=new J,o=new J,s=new J,c=new J,l=new J,u=new J;if(e)for(let d=0,f=e.count;d<f;d+=3){let f=e.getX(d+0),p=e.getX(d+1),m=e.getX(d+2);r.fromBufferAttribute(t,f),i.fromBufferAttribute(t,p),a.fromBufferAttribute(t,m),l.subVectors(a,i),u.subVectors(r,i),l.cross(u),o.fromBufferAttribute(n,f),s.fromBufferAttribute(n,p),c.fromBufferAttribute(n,m),o.add(l),s.add(l),c.add(l),n.setXYZ(f,o.x,o.y,o.z),n.setXYZ(p,s.x,s.y,s.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let e=0,o=t.count;e<o;e+=3)r.fromBufferAttribute(t,e+0),i.fromBufferAttribute(t,e+1),a.fromBufferAttribute(t,e+2),l.subVectors(a,i),u.subVectors(r,i),l.cross(u),n.setXYZ(e+0,l.x,l.y,l.z),n.setXYZ(e+1,l.x,l.y,l.z),n.setXYZ(e+2,l.x,l.y,l.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)Ci.fromBufferAttribute(e,t),Ci.normalize(),e.setXYZ(t,Ci.x,Ci.y,Ci.z)}toNonIndexed(){function t(e,t){let n=e.array,r=e.itemSize,i=e.normalized,a=new n.constructor(t.length*r),o=0,s=0;for(let i=0,c=t.length;i<c;i++){o=e.isInterleavedBufferAttribute?t[i]*e.data.stride+e.offset:t[i]*r;for(let e=0;e<r;e++)a[s++]=n[o++]}return new li(a,r,i)}if(this.index===null)return G(`BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed.`),this;let n=new e,r=this.index.array,i=this.attributes;for(let e in i){let a=i[e],o=t(a,r);n.setAttribute(e,o)}let a=this.morphAttributes;for(let e in a){let i=[],o=a[e];for(let e=0,n=o.length;e<n;e++){let n=o[e],a=t(n,r);i.push(a)}n.morphAttributes[e]=i}n.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let e=0,t=o.length;e<t;e++){let t=o[e];n.addGroup(t.start,t.count,t.materialIndex)}return n}toJSON(){let e={metadata:{version:4.7,type:`BufferGeometry`,generator:`BufferGeometry.toJSON`}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?`BufferGeometry`:this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let t=this.parameters;for(let n in t)t[n]!==void 0&&(e[n]=t[n]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let t in n){let r=n[t];e.data.attributes[t]=r.toJSON(e.data)}let r={},i=!1;for(let t in this.morphAttributes){let n=this.morphAttributes[t],a=[];for(let t=0,r=n.length;t<r;t++){let r=n[t];a.push(r.toJSON(e.data))}a.length>0&&(r[t]=a,i=!0)}i&&(e.data.morphAttributes=r,e.data.morphTargetsRelative=this.morphTargetsRelative);let a=this.groups;a.length>0&&(e.data.groups=JSON.parse(JSON.stringify(a)));let o=this.boundingSphere;return o!==null&&(e.data.boundingSphere=o.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let r=e.attributes;for(let e in r){let n=r[e];this.setAttribute(e,n.clone(t))}let i=e.morphAttributes;for(let e in i){let n=[],r=i[e];for(let e=0,i=r.length;e<i;e++)n.push(r[e].clone(t));this.morphAttributes[e]=n}this.morphTargetsRelative=e.morphTargetsRelative;let a=e.groups;for(let e=0,t=a.length;e<t;e++){let t=a[e];this.addGroup(t.start,t.count,t.materialIndex)}let o=e.boundingBox;o!==null&&(this.boundingBox=o.clone());let s=e.boundingSphere;return s!==null&&(this.boundingSphere=s.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:`dispose`})}},Ti=new J,Ei=new J,Di=new Y,Oi=class{constructor(e=new J(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,r){return this.normal.set(e,t,n),this.constant=r,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let r=Ti.subVectors(n,t).cross(Ei.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(r,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let r=e.delta(Ti),i=this.normal.dot(r);if(i===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let a=-(e.start.dot(this.normal)+this.constant)/i;return n===!0&&(a<0||a>1)?null:t.copy(e.start).addScaledVector(r,a)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||Di.getNormalMatrix(e),r=this.coplanarPoint(Ti).applyMatrix4(e),i=this.normal.applyMatrix3(n).normalize();return this.constant=-r.dot(i),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},ki=0,Ai=class extends Jt{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:ki++}),this.uuid=$t(),this.name=``,this.type=`Material`,this.blending=1,this.side=0,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=204,this.blendDst=205,this.blendEquation=100,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Or(0,0,0),this.blendAlpha=0,this.depthFunc=3,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=519,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Pt,this.stencilZFail=Pt,this.stencilZPass=Pt,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){G(`Material: parameter '${t}' has value of undefined.`);continue}let r=this[t];r===void 0?G(`Material: '${t}' is not a property of THREE.${this.type}.`):r&&r.isColor?r.set(n):r&&r.isVector2&&n&&n.isVector2||r&&r.isEuler&&n&&n.isEuler||r&&r.isVector3&&n&&n.isVector3?r.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e==`string`;t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:`Material`,generator:`Material.toJSON`}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(e=>e.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function r(e){let t=[];for(let n in e){let r=e[n];delete r.metadata,t.push(r)}return t}if(t){let t=r(e.textures),i=r(e.images);t.length>0&&(n.textures=t),i.length>0&&(n.images=i)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new Or().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(e=>new Oi().fromJSON(e))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(this.vertexColors=typeof e.vertexColors==`number`?e.vertexColors>0:e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let t=e.normalScale;Array.isArray(t)===!1&&(t=[t,t]),this.normalScale=new q().fromArray(t)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new q().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let e=t.length;n=Array(e);for(let r=0;r!==e;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:`dispose`})}set needsUpdate(e){e===!0&&this.version++}},ji=new J,Mi=new J,Ni=new J,Pi=new J,Fi=class{constructor(e=new J,t=new J(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,ji)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=ji.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(ji.copy(this.origin).addScaledVector(this.direction,t),ji.distanceToSquared(e))}distanceSqToSegment(e,t,n,r){Mi.copy(e).add(t).multiplyScalar(.5),Ni.copy(t).sub(e).normalize(),Pi.copy(this.origin).sub(Mi);let i=e.distanceTo(t)*.5,a=-this.direction.dot(Ni),o=Pi.dot(this.direction),s=-Pi.dot(Ni),c=Pi.lengthSq(),l=Math.abs(1-a*a),u,d,f,p;if(l>0){if(u=a*s-o,d=a*o-s,p=i*l,u>=0){if(d>=-p){if(d<=p){let e=1/l;u*=e,d*=e,f=u*(u+a*d+2*o)+d*(a*u+d+2*s)+c}else d=i,u=Math.max(0,-(a*d+o)),f=-u*u+d*(d+2*s)+c}else d=-i,u=Math.max(0,-(a*d+o)),f=-u*u+d*(d+2*s)+c}else d<=-p?(u=Math.max(0,-(-a*i+o)),d=u>0?-i:Math.min(Math.max(-i,-s),i),f=-u*u+d*(d+2*s)+c):d<=p?(u=0,d=Math.min(Math.max(-i,-s),i),f=d*(d+2*s)+c):(u=Math.max(0,-(a*i+o)),d=u>0?i:Math.min(Math.max(-i,-s),i),f=-u*u+d*(d+2*s)+c)}else d=a>0?-i:i,u=Math.max(0,-(a*d+o)),f=-u*u+d*(d+2*s)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),r&&r.copy(Mi).addScaledVector(Ni,d),f}intersectSphere(e,t){if(e.radius<0)return null;ji.subVectors(e.center,this.origin);let n=ji.dot(this.direction),r=ji.dot(ji)-n*n,i=e.radius*e.radius;if(r>i)return null;let a=Math.sqrt(i-r),o=n-a,s=n+a;return s<0?null:o<0?this.at(s,t):this.at(o,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,r,i,a,o,s,c=1/this.direction.x,l=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(n=(e.min.x-d.x)*c,r=(e.max.x-d.x)*c):(n=(e.max.x-d.x)*c,r=(e.min.x-d.x)*c),l>=0?(i=(e.min.y-d.y)*l,a=(e.max.y-d.y)*l):(i=(e.max.y-d.y)*l,a=(e.min.y-d.y)*l),n>a||i>r||((i>n||isNaN(n))&&(n=i),(a<r||isNaN(r))&&(r=a),u>=0?(o=(e.min.z-d.z)*u,s=(e.max.z-d.z)*u):(o=(e.max.z-d.z)*u,s=(e.min.z-d.z)*u),n>s||o>r)||((o>n||n!==n)&&(n=o),(s<r||r!==r)&&(r=s),r<0)?null:this.at(n>=0?n:r,t)}intersectsBox(e){return this.intersectBox(e,ji)!==null}intersectTriangle(e,t,n,r,i){let a=this.origin,o=this.direction,s=o.x,c=o.y,l=o.z,u=e.x-a.x,d=e.y-a.y,f=e.z-a.z,p=t.x-a.x,m=t.y-a.y,h=t.z-a.z,g=n.x-a.x,_=n.y-a.y,v=n.z-a.z,y=Math.abs(s),b=Math.abs(c),x=Math.abs(l),S,C,w,T,E,D,O,k,A,j,M,N;if(y>=b&&y>=x?(w=s,D=u,A=p,N=g,s>=0?(S=c,C=l,T=d,E=f,O=m,k=h,j=_,M=v):(S=l,C=c,T=f,E=d,O=h,k=m,j=v,M=_)):b>=x?(w=c,D=d,A=m,N=_,c>=0?(S=l,C=s,T=f,E=u,O=h,k=p,j=v,M=g):(S=s,C=l,T=u,E=f,O=p,k=h,j=g,M=v)):(w=l,D=f,A=h,N=v,l>=0?(S=s,C=c,T=u,E=d,O=p,k=m,j=g,M=_):(S=c,C=s,T=d,E=u,O=m,k=p,j=_,M=g)),w===0)return null;let ee=S/w,te=C/w,ne=1/w,re=T-ee*D,ie=E-te*D,P=O-ee*A,ae=k-te*A,F=j-ee*N,I=M-te*N,L=F*ae-I*P,oe=re*I-ie*F,se=P*ie-ae*re;if(r){if(L<0||oe<0||se<0)return null}else if((L<0||oe<0||se<0)&&(L>0||oe>0||se>0))return null;let ce=L+oe+se;if(ce===0)return null;let le=ne*(L*D+oe*A+se*N);return(ce>0?le<0:le>0)?null:this.at(le/ce,i)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Ii=class extends Ai{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type=`MeshBasicMaterial`,this.color=new Or(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new rr,this.combine=0,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap=`round`,this.wireframeLinejoin=`round`,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},Li=new qn,Ri=new Fi,zi=new gi,Bi=new J,Vi=new J,Hi=new J,Ui=new J,Wi=new J,Gi=new J,Ki=new J,qi=new J,Ji=class extends br{constructor(e=new wi,t=new Ii){super(),this.isMesh=!0,this.type=`Mesh`,this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),this.morphTargetInfluences=e.morphTargetInfluences===void 0?void 0:e.morphTargetInfluences.slice(),this.morphTargetDictionary=e.morphTargetDictionary===void 0?void 0:Object.assign({},e.morphTargetDictionary),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,t=Object.keys(e);if(t.length>0){let n=e[t[0]];if(n!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let e=0,t=n.length;e<t;e++){let t=n[e].name||String(e);this.morphTargetInfluences.push(0),this.morphTargetDictionary[t]=e}}}}getVertexPosition(e,t){let n=this.geometry,r=n.attributes.position,i=n.morphAttributes.position,a=n.morphTargetsRelative;t.fromBufferAttribute(r,e);let o=this.morphTargetInfluences;if(i&&o){Gi.set(0,0,0);for(let n=0,r=i.length;n<r;n++){let r=o[n],s=i[n];r!==0&&(Wi.fromBufferAttribute(s,e),a?Gi.addScaledVector(Wi,r):Gi.addScaledVector(Wi.sub(t),r))}t.add(Gi)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,r=this.material,i=this.matrixWorld;r!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),zi.copy(n.boundingSphere),zi.applyMatrix4(i),Ri.copy(e.ray).recast(e.near),zi.containsPoint(Ri.origin)===!1&&(Ri.intersectSphere(zi,Bi)===null||Ri.origin.distanceToSquared(Bi)>(e.far-e.near)**2)||(Li.copy(i).invert(),Ri.copy(e.ray).applyMatrix4(Li),(n.boundingBox===null||Ri.intersectsBox(n.boundingBox)!==!1)&&this._computeIntersections(e,t,Ri)))}_computeIntersections(e,t,n){let r,i=this.geometry,a=this.material,o=i.index,s=i.attributes.position,c=i.attributes.uv,l=i.attributes.uv1,u=i.attributes.normal,d=i.groups,f=i.drawRange;if(o!==null){if(Array.isArray(a))for(let i=0,s=d.length;i<s;i++){let s=d[i],p=a[s.materialIndex],m=Math.max(s.start,f.start),h=Math.min(o.count,Math.min(s.start+s.count,f.start+f.count));for(let i=m,a=h;i<a;i+=3){let a=o.getX(i),d=o.getX(i+1),f=o.getX(i+2);r=Xi(this,p,e,n,c,l,u,a,d,f),r&&(r.faceIndex=Math.floor(i/3),r.face.materialIndex=s.materialIndex,t.push(r))}}else{let i=Math.max(0,f.start),s=Math.min(o.count,f.start+f.count);for(let d=i,f=s;d<f;d+=3){let i=o.getX(d),s=o.getX(d+1),f=o.getX(d+2);r=Xi(this,a,e,n,c,l,u,i,s,f),r&&(r.faceIndex=Math.floor(d/3),t.push(r))}}}else if(s!==void 0){if(Array.isArray(a))for(let i=0,o=d.length;i<o;i++){let o=d[i],p=a[o.materialIndex],m=Math.max(o.start,f.start),h=Math.min(s.count,Math.min(o.start+o.count,f.start+f.count));for(let i=m,a=h;i<a;i+=3){let a=i,s=i+1,d=i+2;r=Xi(this,p,e,n,c,l,u,a,s,d),r&&(r.faceIndex=Math.floor(i/3),r.face.materialIndex=o.materialIndex,t.push(r))}}else{let i=Math.max(0,f.start),o=Math.min(s.count,f.start+f.count);for(let s=i,d=o;s<d;s+=3){let i=s,o=s+1,d=s+2;r=Xi(this,a,e,n,c,l,u,i,o,d),r&&(r.faceIndex=Math.floor(s/3),t.push(r))}}}}};function Yi(e,t,n,r,i,a,o,s){let c;if(c=t.side===1?r.intersectTriangle(o,a,i,!0,s):r.intersectTriangle(i,a,o,t.side===0,s),c===null)return null;qi.copy(s),qi.applyMatrix4(e.matrixWorld);let l=n.ray.origin.distanceTo(qi);return l<n.near||l>n.far?null:{distance:l,point:qi.clone(),object:e}}function Xi(e,t,n,r,i,a,o,s,c,l){e.getVertexPosition(s,Vi),e.getVertexPosition(c,Hi),e.getVertexPosition(l,Ui);let u=Yi(e,t,n,r,Vi,Hi,Ui,Ki);if(u){let e=new J;Wr.getBarycoord(Ki,Vi,Hi,Ui,e),i&&(u.uv=Wr.getInterpolatedAttribute(i,s,c,l,e,new q)),a&&(u.uv1=Wr.getInterpolatedAttribute(a,s,c,l,e,new q)),o&&(u.normal=Wr.getInterpolatedAttribute(o,s,c,l,e,new J),u.normal.dot(r.direction)>0&&u.normal.multiplyScalar(-1));let t={a:s,b:c,c:l,normal:new J,materialIndex:0};Wr.getNormal(Vi,Hi,Ui,t.normal),u.face=t,u.barycoord=e}return u}var Zi=class extends Vn{constructor(e=null,t=1,n=1,r,i,a,o,s,c=ve,l=ve,u,d){super(null,a,o,s,c,l,r,i,u,d),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}},Qi=new gi,$i=new q(.5,.5),ea=new J,ta=class{constructor(e=new Oi,t=new Oi,n=new Oi,r=new Oi,i=new Oi,a=new Oi){this.planes=[e,t,n,r,i,a]}set(e,t,n,r,i,a){let o=this.planes;return o[0].copy(e),o[1].copy(t),o[2].copy(n),o[3].copy(r),o[4].copy(i),o[5].copy(a),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=Lt,n=!1){let r=this.planes,i=e.elements,a=i[0],o=i[1],s=i[2],c=i[3],l=i[4],u=i[5],d=i[6],f=i[7],p=i[8],m=i[9],h=i[10],g=i[11],_=i[12],v=i[13],y=i[14],b=i[15];if(r[0].setComponents(c-a,f-l,g-p,b-_).normalize(),r[1].setComponents(c+a,f+l,g+p,b+_).normalize(),r[2].setComponents(c+o,f+u,g+m,b+v).normalize(),r[3].setComponents(c-o,f-u,g-m,b-v).normalize(),n)r[4].setComponents(s,d,h,y).normalize(),r[5].setComponents(c-s,f-d,g-h,b-y).normalize();else if(r[4].setComponents(c-s,f-d,g-h,b-y).normalize(),t===2e3)r[5].setComponents(c+s,f+d,g+h,b+y).normalize();else if(t===2001)r[5].setComponents(s,d,h,y).normalize();else throw Error(`THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: `+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Qi.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Qi.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Qi)}intersectsSprite(e){return Qi.center.set(0,0,0),Qi.radius=.7071067811865476+$i.distanceTo(e.center),Qi.applyMatrix4(e.matrixWorld),this.intersectsSphere(Qi)}intersectsSphere(e){let t=this.planes,n=e.center,r=-e.radius;for(let e=0;e<6;e++)if(t[e].distanceToPoint(n)<r)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let r=t[n];if(ea.x=r.normal.x>0?e.max.x:e.min.x,ea.y=r.normal.y>0?e.max.y:e.min.y,ea.z=r.normal.z>0?e.max.z:e.min.z,r.distanceToPoint(ea)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},na=new qn,ra=class e{constructor(){this.coordinateSystem=Lt,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let e=0;e<t.length;e++){let r=t[e];na.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[e]===void 0&&(n[e]=new ta),n[e].setFromProjectionMatrix(na,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let r=0;r<e._count;r++)t[r]===void 0&&(t[r]=new ta),t[r].copy(n[r]);return this._count=e._count,this}clone(){return new e().copy(this)}},ia=class extends Ai{constructor(e){super(),this.isLineBasicMaterial=!0,this.type=`LineBasicMaterial`,this.color=new Or(16777215),this.map=null,this.linewidth=1,this.linecap=`round`,this.linejoin=`round`,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},aa=new J,oa=new J,sa=new qn,ca=new Fi,la=new gi,ua=new J,da=new J,fa=class extends br{constructor(e=new wi,t=new ia){super(),this.isLine=!0,this.type=`Line`,this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),this.morphTargetInfluences=e.morphTargetInfluences===void 0?void 0:e.morphTargetInfluences.slice(),this.morphTargetDictionary=e.morphTargetDictionary===void 0?void 0:Object.assign({},e.morphTargetDictionary),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let e=1,r=t.count;e<r;e++)aa.fromBufferAttribute(t,e-1),oa.fromBufferAttribute(t,e),n[e]=n[e-1],n[e]+=aa.distanceTo(oa);e.setAttribute(`lineDistance`,new fi(n,1))}else G(`Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.`);return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,r=this.matrixWorld,i=e.params.Line.threshold,a=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),la.copy(n.boundingSphere),la.applyMatrix4(r),la.radius+=i,e.ray.intersectsSphere(la)===!1)return;sa.copy(r).invert(),ca.copy(e.ray).applyMatrix4(sa);let o=i/((this.scale.x+this.scale.y+this.scale.z)/3),s=o*o,c=this.isLineSegments?2:1,l=n.index,u=n.attributes.position;if(l!==null){let n=Math.max(0,a.start),r=Math.min(l.count,a.start+a.count);for(let i=n,a=r-1;i<a;i+=c){let n=l.getX(i),r=l.getX(i+1),a=pa(this,e,ca,s,n,r,i);a&&t.push(a)}if(this.isLineLoop){let i=l.getX(r-1),a=l.getX(n),o=pa(this,e,ca,s,i,a,r-1);o&&t.push(o)}}else{let n=Math.max(0,a.start),r=Math.min(u.count,a.start+a.count);for(let i=n,a=r-1;i<a;i+=c){let n=pa(this,e,ca,s,i,i+1,i);n&&t.push(n)}if(this.isLineLoop){let i=pa(this,e,ca,s,r-1,n,r-1);i&&t.push(i)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,t=Object.keys(e);if(t.length>0){let n=e[t[0]];if(n!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let e=0,t=n.length;e<t;e++){let t=n[e].name||String(e);this.morphTargetInfluences.push(0),this.morphTargetDictionary[t]=e}}}}};function pa(e,t,n,r,i,a,o){let s=e.geometry.attributes.position;if(aa.fromBufferAttribute(s,i),oa.fromBufferAttribute(s,a),n.distanceSqToSegment(aa,oa,ua,da)>r)return;ua.applyMatrix4(e.matrixWorld);let c=t.ray.origin.distanceTo(ua);if(!(c<t.near||c>t.far))return{distance:c,point:da.clone().applyMatrix4(e.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:e}}var ma=new J,ha=new J,ga=class extends fa{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type=`LineSegments`}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let e=0,r=t.count;e<r;e+=2)ma.fromBufferAttribute(t,e),ha.fromBufferAttribute(t,e+1),n[e]=e===0?0:n[e-1],n[e+1]=n[e]+ma.distanceTo(ha);e.setAttribute(`lineDistance`,new fi(n,1))}else G(`LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.`);return this}},_a=class extends Vn{constructor(e=[],t=301,n,r,i,a,o,s,c,l){super(e,t,n,r,i,a,o,s,c,l),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}},va=class extends Vn{constructor(e,t,n=we,r,i,a,o=ve,s=ve,c,l=Ne,u=1){if(l!==1026&&l!==1027)throw Error(`THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat`);super({width:e,height:t,depth:u},r,i,a,o,s,l,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Ln(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},ya=class extends va{constructor(e,t=we,n=301,r,i,a=ve,o=ve,s,c=Ne){let l={width:e,height:e,depth:1},u=[l,l,l,l,l,l];super(e,e,t,n,r,i,a,o,s,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},ba=class extends Vn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},xa=class e extends wi{constructor(e=1,t=1,n=1,r=1,i=1,a=1){super(),this.type=`BoxGeometry`,this.parameters={width:e,height:t,depth:n,widthSegments:r,heightSegments:i,depthSegments:a};let o=this;r=Math.floor(r),i=Math.floor(i),a=Math.floor(a);let s=[],c=[],l=[],u=[],d=0,f=0;p(`z`,`y`,`x`,-1,-1,n,t,e,a,i,0),p(`z`,`y`,`x`,1,-1,n,t,-e,a,i,1),p(`x`,`z`,`y`,1,1,e,n,t,r,a,2),p(`x`,`z`,`y`,1,-1,e,n,-t,r,a,3),p(`x`,`y`,`z`,1,-1,e,t,n,r,i,4),p(`x`,`y`,`z`,-1,-1,e,t,-n,r,i,5),this.setIndex(s),this.setAttribute(`position`,new fi(c,3)),this.setAttribute(`normal`,new fi(l,3)),this.setAttribute(`uv`,new fi(u,2));function p(e,t,n,r,i,a,p,m,h,g,_){let v=a/h,y=p/g,b=a/2,x=p/2,S=m/2,C=h+1,w=g+1,T=0,E=0,D=new J;for(let a=0;a<w;a++){let o=a*y-x;for(let s=0;s<C;s++)D[e]=(s*v-b)*r,D[t]=o*i,D[n]=S,c.push(D.x,D.y,D.z),D[e]=0,D[t]=0,D[n]=m>0?1:-1,l.push(D.x,D.y,D.z),u.push(s/h),u.push(1-a/g),T+=1}for(let e=0;e<g;e++)for(let t=0;t<h;t++){let n=d+t+C*e,r=d+t+C*(e+1),i=d+(t+1)+C*(e+1),a=d+(t+1)+C*e;s.push(n,r,a),s.push(r,i,a),E+=6}o.addGroup(f,E,_),f+=E,d+=T}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(t){return new e(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}},Sa=class e extends wi{constructor(e=1,t=1,n=1,r=1){super(),this.type=`PlaneGeometry`,this.parameters={width:e,height:t,widthSegments:n,heightSegments:r};let i=e/2,a=t/2,o=Math.floor(n),s=Math.floor(r),c=o+1,l=s+1,u=e/o,d=t/s,f=[],p=[],m=[],h=[];for(let e=0;e<l;e++){let t=e*d-a;for(let n=0;n<c;n++){let r=n*u-i;p.push(r,-t,0),m.push(0,0,1),h.push(n/o),h.push(1-e/s)}}for(let e=0;e<s;e++)for(let t=0;t<o;t++){let n=t+c*e,r=t+c*(e+1),i=t+1+c*(e+1),a=t+1+c*e;f.push(n,r,a),f.push(r,i,a)}this.setIndex(f),this.setAttribute(`position`,new fi(p,3)),this.setAttribute(`normal`,new fi(m,3)),this.setAttribute(`uv`,new fi(h,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(t){return new e(t.width,t.height,t.widthSegments,t.heightSegments)}};function Ca(e){let t={};for(let n in e){t[n]={};for(let r in e[n]){let i=e[n][r];if(Ta(i))i.isRenderTargetTexture?(G(`UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms().`),t[n][r]=null):t[n][r]=i.clone();else if(Array.isArray(i)){if(Ta(i[0])){let e=[];for(let t=0,n=i.length;t<n;t++)e[t]=i[t].clone();t[n][r]=e}else t[n][r]=i.slice()}else t[n][r]=i}}return t}function wa(e){let t={};for(let n=0;n<e.length;n++){let r=Ca(e[n]);for(let e in r)t[e]=r[e]}return t}function Ta(e){return e&&(e.isColor||e.isMatrix3||e.isMatrix4||e.isVector2||e.isVector3||e.isVector4||e.isTexture||e.isQuaternion)}function Ea(e){let t=[];for(let n=0;n<e.length;n++)t.push(e[n].clone());return t}function Da(e){let t=e.getRenderTarget();return t===null?e.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:jn.workingColorSpace}var Oa={clone:Ca,merge:wa},ka=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Aa=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ja=class extends Ai{constructor(e){super(),this.isShaderMaterial=!0,this.type=`ShaderMaterial`,this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=ka,this.fragmentShader=Aa,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Ca(e.uniforms),this.uniformsGroups=Ea(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let n in this.uniforms){let r=this.uniforms[n].value;r&&r.isTexture?t.uniforms[n]={type:`t`,value:r.toJSON(e).uuid}:r&&r.isColor?t.uniforms[n]={type:`c`,value:r.getHex()}:r&&r.isVector2?t.uniforms[n]={type:`v2`,value:r.toArray()}:r&&r.isVector3?t.uniforms[n]={type:`v3`,value:r.toArray()}:r&&r.isVector4?t.uniforms[n]={type:`v4`,value:r.toArray()}:r&&r.isMatrix3?t.uniforms[n]={type:`m3`,value:r.toArray()}:r&&r.isMatrix4?t.uniforms[n]={type:`m4`,value:r.toArray()}:t.uniforms[n]={value:r}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let e in this.extensions)this.extensions[e]===!0&&(n[e]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let r=e.uniforms[n];switch(this.uniforms[n]={},r.type){case`t`:this.uniforms[n].value=t[r.value]||null;break;case`c`:this.uniforms[n].value=new Or().setHex(r.value);break;case`v2`:this.uniforms[n].value=new q().fromArray(r.value);break;case`v3`:this.uniforms[n].value=new J().fromArray(r.value);break;case`v4`:this.uniforms[n].value=new Hn().fromArray(r.value);break;case`m3`:this.uniforms[n].value=new Y().fromArray(r.value);break;case`m4`:this.uniforms[n].value=new qn().fromArray(r.value);break;default:this.uniforms[n].value=r.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let t in e.extensions)this.extensions[t]=e.extensions[t];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Ma=class extends ja{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type=`RawShaderMaterial`}},Na=class extends Ai{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type=`MeshDepthMaterial`,this.depthPacking=kt,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Pa=class extends Ai{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type=`MeshDistanceMaterial`,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Fa(e,t){return!e||e.constructor===t?e:typeof t.BYTES_PER_ELEMENT==`number`?new t(e):Array.prototype.slice.call(e)}function Ia(e){return e!==void 0&&e.inTangents!==void 0&&e.outTangents!==void 0}var La=class{constructor(e,t,n,r){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=r===void 0?new t.constructor(n):r,this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,r=t[n],i=t[n-1];validate_interval:{seek:{let a;linear_scan:{forward_scan:if(!(e<r)){for(let a=n+2;;){if(r===void 0){if(e<i)break forward_scan;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(i=r,r=t[++n],e<r)break seek}a=t.length;break linear_scan}if(!(e>=i)){let o=t[1];e<o&&(n=2,i=o);for(let a=n-2;;){if(i===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===a)break;if(r=i,i=t[--n-1],e>=i)break seek}a=n,n=0;break linear_scan}break validate_interval}for(;n<a;){let r=n+a>>>1;e<t[r]?a=r:n=r+1}if(r=t[n],i=t[n-1],i===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(r===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,i,r)}return this.interpolate_(n,i,e,r)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,r=this.valueSize,i=e*r;for(let e=0;e!==r;++e)t[e]=n[i+e];return t}interpolate_(){throw Error(`THREE.Interpolant: Call to abstract method.`)}intervalChanged_(){}},Ra=class extends La{constructor(e,t,n,r){super(e,t,n,r),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Et,endingEnd:Et}}intervalChanged_(e,t,n){let r=this.parameterPositions,i=e-2,a=e+1,o=r[i],s=r[a];if(o===void 0)switch(this.getSettings_().endingStart){case Dt:i=e,o=2*t-n;break;case Ot:i=r.length-2,o=t+r[i]-r[i+1];break;default:i=e,o=n}if(s===void 0)switch(this.getSettings_().endingEnd){case Dt:a=e,s=2*n-t;break;case Ot:a=1,s=n+r[1]-r[0];break;default:a=e-1,s=t}let c=(n-t)*.5,l=this.valueSize;this._weightPrev=c/(t-o),this._weightNext=c/(s-n),this._offsetPrev=i*l,this._offsetNext=a*l}interpolate_(e,t,n,r){let i=this.resultBuffer,a=this.sampleValues,o=this.valueSize,s=e*o,c=s-o,l=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(n-t)/(r-t),m=p*p,h=m*p,g=-d*h+2*d*m-d*p,_=(1+d)*h+(-1.5-2*d)*m+(-.5+d)*p+1,v=(-1-f)*h+(1.5+f)*m+.5*p,y=f*h-f*m;for(let e=0;e!==o;++e)i[e]=g*a[l+e]+_*a[c+e]+v*a[s+e]+y*a[u+e];return i}},za=class extends La{constructor(e,t,n,r){super(e,t,n,r)}interpolate_(e,t,n,r){let i=this.resultBuffer,a=this.sampleValues,o=this.valueSize,s=e*o,c=s-o,l=(n-t)/(r-t),u=1-l;for(let e=0;e!==o;++e)i[e]=a[c+e]*u+a[s+e]*l;return i}},Ba=class extends La{constructor(e,t,n,r){super(e,t,n,r)}interpolate_(e){return this.copySampleValue_(e-1)}},Va=class extends La{interpolate_(e,t,n,r){let i=this.resultBuffer,a=this.sampleValues,o=this.valueSize,s=e*o,c=s-o,l=this.inTangents,u=this.outTangents;if(!l||!u){let e=(n-t)/(r-t),l=1-e;for(let t=0;t!==o;++t)i[t]=a[c+t]*l+a[s+t]*e;return i}let d=o*2,f=e-1;for(let p=0;p!==o;++p){let o=a[c+p],m=a[s+p],h=f*d+p*2,g=u[h],_=u[h+1],v=e*d+p*2,y=l[v],b=l[v+1],x=Wa(n,t,g,y,r);i[p]=Ha(x,o,_,b,m)}return i}};function Ha(e,t,n,r,i){let a=1-e;return a*a*a*t+3*a*a*e*n+3*a*e*e*r+e*e*e*i}function Ua(e,t,n,r,i){let a=1-e;return 3*a*a*(n-t)+6*a*e*(r-n)+3*e*e*(i-r)}function Wa(e,t,n,r,i){let a=(e-t)/(i-t);for(let o=0;o<8;o++){let o=Ha(a,t,n,r,i)-e;if(Math.abs(o)<1e-10)break;let s=Ua(a,t,n,r,i);if(Math.abs(s)<1e-10)break;a=Math.max(0,Math.min(1,a-o/s))}return a}var Ga=class{constructor(e,t,n,r){if(e===void 0)throw Error(`THREE.KeyframeTrack: track name is undefined`);if(t===void 0||t.length===0)throw Error(`THREE.KeyframeTrack: no keyframes in track named `+e);this.name=e,this.times=Fa(t,this.TimeBufferType),this.values=Fa(n,this.ValueBufferType),this.setInterpolation(r||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:Fa(e.times,Array),values:Fa(e.values,Array)};let t=e.getInterpolation();t!==e.DefaultInterpolation&&(n.interpolation=t),Ia(e.settings)&&(n.settings={inTangents:Fa(e.settings.inTangents,Array),outTangents:Fa(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new Ba(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new za(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Ra(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Va(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case St:t=this.InterpolantFactoryMethodDiscrete;break;case Ct:t=this.InterpolantFactoryMethodLinear;break;case wt:t=this.InterpolantFactoryMethodSmooth;break;case Tt:t=this.InterpolantFactoryMethodBezier}if(t===void 0){let t=`unsupported interpolation for `+this.ValueTypeName+` keyframe track named `+this.name;if(this.createInterpolant===void 0){if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw Error(t)}return G(`KeyframeTrack:`,t),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return St;case this.InterpolantFactoryMethodLinear:return Ct;case this.InterpolantFactoryMethodSmooth:return wt;case this.InterpolantFactoryMethodBezier:return Tt}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,r=t.length;n!==r;++n)t[n]+=e;Ia(this.settings)&&(Ka(this.settings.inTangents,e),Ka(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,r=t.length;n!==r;++n)t[n]*=e;Ia(this.settings)&&(qa(this.settings.inTangents,e),qa(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,r=n.length,i=0,a=r-1;for(;i!==r&&n[i]<e;)++i;for(;a!==-1&&n[a]>t;)--a;if(++a,i!==0||a!==r){i>=a&&(a=Math.max(a,1),i=a-1);let e=this.getValueSize();this.times=n.slice(i,a),this.values=this.values.slice(i*e,a*e)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(K(`KeyframeTrack: Invalid value size in track.`,this),e=!1);let n=this.times,r=this.values,i=n.length;i===0&&(K(`KeyframeTrack: Track is empty.`,this),e=!1);let a=null;for(let t=0;t!==i;t++){let r=n[t];if(typeof r==`number`&&isNaN(r)){K(`KeyframeTrack: Time is not a valid number.`,this,t,r),e=!1;break}if(a!==null&&a>r){K(`KeyframeTrack: Out of order keys.`,this,t,r,a),e=!1;break}a=r}if(r!==void 0&&zt(r))for(let t=0,n=r.length;t!==n;++t){let n=r[t];if(isNaN(n)){K(`KeyframeTrack: Value is not a valid number.`,this,t,n),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),r=this.getInterpolation()===wt,i=e.length-1,a=1;for(let o=1;o<i;++o){let i=!1,s=e[o];if(s!==e[o+1]&&(o!==1||s!==e[0])){if(r)i=!0;else{let e=o*n,r=e-n,a=e+n;for(let o=0;o!==n;++o){let n=t[e+o];if(n!==t[r+o]||n!==t[a+o]){i=!0;break}}}}if(i){if(o!==a){e[a]=e[o];let r=o*n,i=a*n;for(let e=0;e!==n;++e)t[i+e]=t[r+e]}++a}}if(i>0){e[a]=e[i];for(let e=i*n,r=a*n,o=0;o!==n;++o)t[r+o]=t[e+o];++a}return a===e.length?(this.times=e,this.values=t):(this.times=e.slice(0,a),this.values=t.slice(0,a*n)),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,r=new n(this.name,e,t);return r.createInterpolant=this.createInterpolant,Ia(this.settings)&&(r.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),r}};function Ka(e,t){for(let n=0,r=e.length;n!==r;n+=2)e[n]+=t}function qa(e,t){for(let n=0,r=e.length;n!==r;n+=2)e[n]*=t}Ga.prototype.ValueTypeName=``,Ga.prototype.TimeBufferType=Float32Array,Ga.prototype.ValueBufferType=Float32Array,Ga.prototype.DefaultInterpolation=Ct;var Ja=class extends Ga{constructor(e,t,n){super(e,t,n)}};Ja.prototype.ValueTypeName=`bool`,Ja.prototype.ValueBufferType=Array,Ja.prototype.DefaultInterpolation=St,Ja.prototype.InterpolantFactoryMethodLinear=void 0,Ja.prototype.InterpolantFactoryMethodSmooth=void 0;var Ya=class extends Ga{constructor(e,t,n,r){super(e,t,n,r)}};Ya.prototype.ValueTypeName=`color`;var Xa=class extends Ga{constructor(e,t,n,r){super(e,t,n,r)}};Xa.prototype.ValueTypeName=`number`;var Za=class extends La{constructor(e,t,n,r){super(e,t,n,r)}interpolate_(e,t,n,r){let i=this.resultBuffer,a=this.sampleValues,o=this.valueSize,s=(n-t)/(r-t),c=e*o;for(let e=c+o;c!==e;c+=4)wn.slerpFlat(i,0,a,c-o,a,c,s);return i}},Qa=class extends Ga{constructor(e,t,n,r){super(e,t,n,r)}InterpolantFactoryMethodLinear(e){return new Za(this.times,this.values,this.getValueSize(),e)}};Qa.prototype.ValueTypeName=`quaternion`,Qa.prototype.InterpolantFactoryMethodSmooth=void 0;var $a=class extends Ga{constructor(e,t,n){super(e,t,n)}};$a.prototype.ValueTypeName=`string`,$a.prototype.ValueBufferType=Array,$a.prototype.DefaultInterpolation=St,$a.prototype.InterpolantFactoryMethodLinear=void 0,$a.prototype.InterpolantFactoryMethodSmooth=void 0;var eo=class extends Ga{constructor(e,t,n,r){super(e,t,n,r)}};eo.prototype.ValueTypeName=`vector`;var to=new J,no=new wn,ro=new J,io=class extends br{constructor(){super(),this.isCamera=!0,this.type=`Camera`,this.matrixWorldInverse=new qn,this.projectionMatrix=new qn,this.projectionMatrixInverse=new qn,this.coordinateSystem=Lt,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(to,no,ro),ro.x===1&&ro.y===1&&ro.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(to,no,ro.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(to,no,ro),ro.x===1&&ro.y===1&&ro.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(to,no,ro.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},ao=new J,oo=new q,so=new q,co=class extends io{constructor(e=50,t=1,n=.1,r=2e3){super(),this.isPerspectiveCamera=!0,this.type=`PerspectiveCamera`,this.fov=e,this.zoom=1,this.near=n,this.far=r,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Qt*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Zt*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Qt*2*Math.atan(Math.tan(Zt*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){ao.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(ao.x,ao.y).multiplyScalar(-e/ao.z),ao.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(ao.x,ao.y).multiplyScalar(-e/ao.z)}getViewSize(e,t){return this.getViewBounds(e,oo,so),t.subVectors(so,oo)}setViewOffset(e,t,n,r,i,a){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=r,this.view.width=i,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Zt*.5*this.fov)/this.zoom,n=2*t,r=this.aspect*n,i=-.5*r,a=this.view;if(this.view!==null&&this.view.enabled){let e=a.fullWidth,o=a.fullHeight;i+=a.offsetX*r/e,t-=a.offsetY*n/o,r*=a.width/e,n*=a.height/o}let o=this.filmOffset;o!==0&&(i+=e*o/this.getFilmWidth()),this.projectionMatrix.makePerspective(i,i+r,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}},lo=class extends io{constructor(e=-1,t=1,n=1,r=-1,i=.1,a=2e3){super(),this.isOrthographicCamera=!0,this.type=`OrthographicCamera`,this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=r,this.near=i,this.far=a,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,r,i,a){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=r,this.view.width=i,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,r=(this.top+this.bottom)/2,i=n-e,a=n+e,o=r+t,s=r-t;if(this.view!==null&&this.view.enabled){let e=(this.right-this.left)/this.view.fullWidth/this.zoom,t=(this.top-this.bottom)/this.view.fullHeight/this.zoom;i+=e*this.view.offsetX,a=i+e*this.view.width,o-=t*this.view.offsetY,s=o-t*this.view.height}this.projectionMatrix.makeOrthographic(i,a,o,s,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},uo=-90,fo=1,po=class extends br{constructor(e,t,n){super(),this.type=`CubeCamera`,this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let r=new co(uo,fo,e,t);r.layers=this.layers,this.add(r);let i=new co(uo,fo,e,t);i.layers=this.layers,this.add(i);let a=new co(uo,fo,e,t);a.layers=this.layers,this.add(a);let o=new co(uo,fo,e,t);o.layers=this.layers,this.add(o);let s=new co(uo,fo,e,t);s.layers=this.layers,this.add(s);let c=new co(uo,fo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,r,i,a,o,s]=t;for(let e of t)this.remove(e);if(e===2e3)n.up.set(0,1,0),n.lookAt(1,0,0),r.up.set(0,1,0),r.lookAt(-1,0,0),i.up.set(0,0,-1),i.lookAt(0,1,0),a.up.set(0,0,1),a.lookAt(0,-1,0),o.up.set(0,1,0),o.lookAt(0,0,1),s.up.set(0,1,0),s.lookAt(0,0,-1);else if(e===2001)n.up.set(0,-1,0),n.lookAt(-1,0,0),r.up.set(0,-1,0),r.lookAt(1,0,0),i.up.set(0,0,1),i.lookAt(0,1,0),a.up.set(0,0,-1),a.lookAt(0,-1,0),o.up.set(0,-1,0),o.lookAt(0,0,1),s.up.set(0,-1,0),s.lookAt(0,0,-1);else throw Error(`THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: `+e);for(let e of t)this.add(e),e.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:r}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[i,a,o,s,c,l]=this.children,u=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),p=e.xr.enabled;e.xr.enabled=!1;let m=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let h=!1;h=e.isWebGLRenderer===!0?e.state.buffers.depth.getReversed():e.reversedDepthBuffer,e.setRenderTarget(n,0,r),h&&e.autoClear===!1&&e.clearDepth(),e.render(t,i),e.setRenderTarget(n,1,r),h&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,2,r),h&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,3,r),h&&e.autoClear===!1&&e.clearDepth(),e.render(t,s),e.setRenderTarget(n,4,r),h&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=m,e.setRenderTarget(n,5,r),h&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(u,d,f),e.xr.enabled=p,n.texture.needsPMREMUpdate=!0}},mo=class extends co{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}},ho=`\\[\\]\\.:\\/`,go=RegExp(`[\\[\\]\\.:\\/]`,`g`),_o=`[^\\[\\]\\.:\\/]`,vo=`[^`+ho.replace(`\\.`,``)+`]`,yo=`((?:WC+[\\/:])*)`.replace(`WC`,_o),bo=`(WCOD+)?`.replace(`WCOD`,vo),xo=`(?:\\.(WC+)(?:\\[(.+)\\])?)?`.replace(`WC`,_o),So=`\\.(WC+)(?:\\[(.+)\\])?`.replace(`WC`,_o),Co=RegExp(`^`+yo+bo+xo+So+`$`),wo=[`material`,`materials`,`bones`,`map`],To=class{constructor(e,t,n){let r=n||Eo.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,r)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,r=this._bindings[n];r!==void 0&&r.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let r=this._targetGroup.nCachedObjects_,i=n.length;r!==i;++r)n[r].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},Eo=class e{constructor(t,n,r){this.path=n,this.parsedPath=r||e.parseTrackName(n),this.node=e.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,n,r){return t&&t.isAnimationObjectGroup?new e.Composite(t,n,r):new e(t,n,r)}static sanitizeNodeName(e){return e.replace(/\s/g,`_`).replace(go,``)}static parseTrackName(e){let t=Co.exec(e);if(t===null)throw Error(`THREE.PropertyBinding: Cannot parse trackName: `+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},r=n.nodeName&&n.nodeName.lastIndexOf(`.`);if(r!==void 0&&r!==-1){let e=n.nodeName.substring(r+1);wo.indexOf(e)!==-1&&(n.nodeName=n.nodeName.substring(0,r),n.objectName=e)}if(n.propertyName===null||n.propertyName.length===0)throw Error(`THREE.PropertyBinding: can not parse propertyName from trackName: `+e);return n}static findNode(e,t){if(t===void 0||t===``||t===`.`||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(e){for(let r=0;r<e.length;r++){let i=e[r];if(i.name===t||i.uuid===t)return i;let a=n(i.children);if(a)return a}return null},r=n(e.children);if(r)return r}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let r=0,i=n.length;r!==i;++r)e[t++]=n[r]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let r=0,i=n.length;r!==i;++r)n[r]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let r=0,i=n.length;r!==i;++r)n[r]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let r=0,i=n.length;r!==i;++r)n[r]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let t=this.node,n=this.parsedPath,r=n.objectName,i=n.propertyName,a=n.propertyIndex;if(t||(t=e.findNode(this.rootNode,n.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){G(`PropertyBinding: No target node found for track: `+this.path+`.`);return}if(r){let e=n.objectIndex;switch(r){case`materials`:if(!t.material){K(`PropertyBinding: Can not bind to material as node does not have a material.`,this);return}if(!t.material.materials){K(`PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.`,this);return}t=t.material.materials;break;case`bones`:if(!t.skeleton){K(`PropertyBinding: Can not bind to bones as node does not have a skeleton.`,this);return}t=t.skeleton.bones;for(let n=0;n<t.length;n++)if(t[n].name===e){e=n;break}break;case`map`:if(`map`in t){t=t.map;break}if(!t.material){K(`PropertyBinding: Can not bind to material as node does not have a material.`,this);return}if(!t.material.map){K(`PropertyBinding: Can not bind to material.map as node.material does not have a map.`,this);return}t=t.material.map;break;default:if(t[r]===void 0){K(`PropertyBinding: Can not bind to objectName of node undefined.`,this);return}t=t[r]}if(e!==void 0){if(t[e]===void 0){K(`PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.`,this,t);return}t=t[e]}}let o=t[i];if(o===void 0){let e=n.nodeName;K(`PropertyBinding: Trying to update property for track: `+e+`.`+i+` but it wasn't found.`,t);return}let s=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?s=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(s=this.Versioning.MatrixWorldNeedsUpdate);let c=this.BindingType.Direct;if(a!==void 0){if(i===`morphTargetInfluences`){if(!t.geometry){K(`PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.`,this);return}if(!t.geometry.morphAttributes){K(`PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.`,this);return}t.morphTargetDictionary[a]!==void 0&&(a=t.morphTargetDictionary[a])}c=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=a}else o.fromArray!==void 0&&o.toArray!==void 0?(c=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(c=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=i;this.getValue=this.GetterByBindingType[c],this.setValue=this.SetterByBindingTypeAndVersioning[c][s]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Eo.Composite=To,Eo.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3},Eo.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2},Eo.prototype.GetterByBindingType=[Eo.prototype._getValue_direct,Eo.prototype._getValue_array,Eo.prototype._getValue_arrayElement,Eo.prototype._getValue_toArray],Eo.prototype.SetterByBindingTypeAndVersioning=[[Eo.prototype._setValue_direct,Eo.prototype._setValue_direct_setNeedsUpdate,Eo.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Eo.prototype._setValue_array,Eo.prototype._setValue_array_setNeedsUpdate,Eo.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Eo.prototype._setValue_arrayElement,Eo.prototype._setValue_arrayElement_setNeedsUpdate,Eo.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Eo.prototype._setValue_fromArray,Eo.prototype._setValue_fromArray_setNeedsUpdate,Eo.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var Do=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){let e=1e-6;return this.phi=en(this.phi,e,Math.PI-e),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(en(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};(class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,r){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,r)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,r){let i=this.elements;return i[0]=e,i[2]=t,i[1]=n,i[3]=r,this}});var Oo=class extends Jt{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function ko(e,t,n,r){let i=Ao(r);switch(n){case Ae:return e*t;case Fe:return e*t/i.components*i.byteLength;case Ie:return e*t/i.components*i.byteLength;case Le:return e*t*2/i.components*i.byteLength;case Re:return e*t*2/i.components*i.byteLength;case je:return e*t*3/i.components*i.byteLength;case Me:return e*t*4/i.components*i.byteLength;case ze:return e*t*4/i.components*i.byteLength;case Be:case Ve:return Math.floor((e+3)/4)*Math.floor((t+3)/4)*8;case He:case Ue:return Math.floor((e+3)/4)*Math.floor((t+3)/4)*16;case Ge:case qe:return Math.max(e,16)*Math.max(t,8)/4;case We:case Ke:return Math.max(e,8)*Math.max(t,8)/2;case Je:case Ye:case Ze:case Qe:return Math.floor((e+3)/4)*Math.floor((t+3)/4)*8;case Xe:case $e:case et:return Math.floor((e+3)/4)*Math.floor((t+3)/4)*16;case tt:return Math.floor((e+3)/4)*Math.floor((t+3)/4)*16;case nt:return Math.floor((e+4)/5)*Math.floor((t+3)/4)*16;case rt:return Math.floor((e+4)/5)*Math.floor((t+4)/5)*16;case it:return Math.floor((e+5)/6)*Math.floor((t+4)/5)*16;case at:return Math.floor((e+5)/6)*Math.floor((t+5)/6)*16;case ot:return Math.floor((e+7)/8)*Math.floor((t+4)/5)*16;case st:return Math.floor((e+7)/8)*Math.floor((t+5)/6)*16;case ct:return Math.floor((e+7)/8)*Math.floor((t+7)/8)*16;case lt:return Math.floor((e+9)/10)*Math.floor((t+4)/5)*16;case ut:return Math.floor((e+9)/10)*Math.floor((t+5)/6)*16;case dt:return Math.floor((e+9)/10)*Math.floor((t+7)/8)*16;case ft:return Math.floor((e+9)/10)*Math.floor((t+9)/10)*16;case pt:return Math.floor((e+11)/12)*Math.floor((t+9)/10)*16;case mt:return Math.floor((e+11)/12)*Math.floor((t+11)/12)*16;case ht:case gt:case _t:return Math.ceil(e/4)*Math.ceil(t/4)*16;case vt:case yt:return Math.ceil(e/4)*Math.ceil(t/4)*8;case bt:case xt:return Math.ceil(e/4)*Math.ceil(t/4)*16}throw Error(`Unable to determine texture byte length for ${n} format.`)}function Ao(e){switch(e){case xe:case V:return{byteLength:1,components:1};case Ce:case Se:case Ee:return{byteLength:2,components:1};case De:case Oe:return{byteLength:2,components:4};case we:case H:case Te:return{byteLength:4,components:1};case U:case W:return{byteLength:4,components:3}}throw Error(`THREE.TextureUtils: Unknown texture type ${e}.`)}typeof __THREE_DEVTOOLS__<`u`&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent(`register`,{detail:{revision:`187`}})),typeof window<`u`&&(window.__THREE__?G(`WARNING: Multiple instances of Three.js being imported.`):window.__THREE__=`187`);function jo(){let e=null,t=!1,n=null,r=null;function i(t,a){r=e.requestAnimationFrame(i),n(t,a)}return{start:function(){t!==!0&&n!==null&&e!==null&&(r=e.requestAnimationFrame(i),t=!0)},stop:function(){e!==null&&e.cancelAnimationFrame(r),t=!1},setAnimationLoop:function(e){n=e},setContext:function(t){e=t}}}function Mo(e){let t=new WeakMap;function n(t,n){let r=t.array,i=t.usage,a=r.byteLength,o=e.createBuffer();e.bindBuffer(n,o),e.bufferData(n,r,i),t.onUploadCallback();let s;if(r instanceof Float32Array)s=e.FLOAT;else if(typeof Float16Array<`u`&&r instanceof Float16Array)s=e.HALF_FLOAT;else if(r instanceof Uint16Array)s=t.isFloat16BufferAttribute?e.HALF_FLOAT:e.UNSIGNED_SHORT;else if(r instanceof Int16Array)s=e.SHORT;else if(r instanceof Uint32Array)s=e.UNSIGNED_INT;else if(r instanceof Int32Array)s=e.INT;else if(r instanceof Int8Array)s=e.BYTE;else if(r instanceof Uint8Array)s=e.UNSIGNED_BYTE;else if(r instanceof Uint8ClampedArray)s=e.UNSIGNED_BYTE;else throw Error(`THREE.WebGLAttributes: Unsupported buffer data format: `+r);return{buffer:o,type:s,bytesPerElement:r.BYTES_PER_ELEMENT,version:t.version,size:a}}function r(t,n,r){let i=n.array,a=n.updateRanges;if(e.bindBuffer(r,t),a.length===0)e.bufferSubData(r,0,i);else{a.sort((e,t)=>e.start-t.start);let t=0;for(let e=1;e<a.length;e++){let n=a[t],r=a[e];r.start<=n.start+n.count+1?n.count=Math.max(n.count,r.start+r.count-n.start):(++t,a[t]=r)}a.length=t+1;for(let t=0,n=a.length;t<n;t++){let n=a[t];e.bufferSubData(r,n.start*i.BYTES_PER_ELEMENT,i,n.start,n.count)}n.clearUpdateRanges()}n.onUploadCallback()}function i(e){return e.isInterleavedBufferAttribute&&(e=e.data),t.get(e)}function a(n){n.isInterleavedBufferAttribute&&(n=n.data);let r=t.get(n);r&&(e.deleteBuffer(r.buffer),t.delete(n))}function o(e,i){if(e.isInterleavedBufferAttribute&&(e=e.data),e.isGLBufferAttribute){let n=t.get(e);(!n||n.version<e.version)&&t.set(e,{buffer:e.buffer,type:e.type,bytesPerElement:e.elementSize,version:e.version});return}let a=t.get(e);if(a===void 0)t.set(e,n(e,i));else if(a.version<e.version){if(a.size!==e.array.byteLength)throw Error(`THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.`);r(a.buffer,e,i),a.version=e.version}}return{get:i,remove:a,update:o}}var No={alphahash_fragment:`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,alphahash_pars_fragment:`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,alphamap_fragment:`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,alphamap_pars_fragment:`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,alphatest_fragment:`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,alphatest_pars_fragment:`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,aomap_fragment:`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,aomap_pars_fragment:`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,batching_pars_vertex:`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,batching_vertex:`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,begin_vertex:`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,beginnormal_vertex:`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,bsdfs:`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,iridescence_fragment:`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,bumpmap_pars_fragment:`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,clipping_planes_fragment:`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,clipping_planes_pars_fragment:`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,clipping_planes_pars_vertex:`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,clipping_planes_vertex:`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,color_fragment:`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,color_pars_fragment:`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,color_pars_vertex:`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,color_vertex:`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,common:`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,defaultnormal_vertex:`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,displacementmap_pars_vertex:`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,displacementmap_vertex:`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,emissivemap_fragment:`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,emissivemap_pars_fragment:`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,colorspace_fragment:`gl_FragColor = linearToOutputTexel( gl_FragColor );`,colorspace_pars_fragment:`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,envmap_fragment:`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,envmap_common_pars_fragment:`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,envmap_pars_fragment:`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,envmap_pars_vertex:`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,envmap_physical_pars_fragment:`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,envmap_vertex:`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,fog_vertex:`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,fog_pars_vertex:`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,fog_fragment:`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,fog_pars_fragment:`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,gradientmap_pars_fragment:`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,lightmap_pars_fragment:`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,lights_lambert_fragment:`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,lights_lambert_pars_fragment:`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,lights_pars_begin:`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,lights_toon_fragment:`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,lights_toon_pars_fragment:`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,lights_phong_fragment:`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,lights_phong_pars_fragment:`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,lights_physical_fragment:`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,lights_physical_pars_fragment:`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,lights_fragment_begin:`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,lights_fragment_maps:`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,lights_fragment_end:`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,lightprobes_pars_fragment:`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,logdepthbuf_fragment:`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,logdepthbuf_pars_fragment:`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,logdepthbuf_pars_vertex:`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,logdepthbuf_vertex:`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,map_fragment:`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,map_pars_fragment:`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,map_particle_fragment:`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,map_particle_pars_fragment:`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,metalnessmap_fragment:`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,metalnessmap_pars_fragment:`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,morphinstance_vertex:`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,morphcolor_vertex:`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,morphnormal_vertex:`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,morphtarget_pars_vertex:`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,morphtarget_vertex:`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,normal_fragment_begin:`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,normal_fragment_maps:`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,normal_pars_fragment:`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,normal_pars_vertex:`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,normal_vertex:`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,normalmap_pars_fragment:`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,clearcoat_normal_fragment_begin:`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,clearcoat_normal_fragment_maps:`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,clearcoat_pars_fragment:`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,iridescence_pars_fragment:`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,opaque_fragment:`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,packing:`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,premultiplied_alpha_fragment:`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,project_vertex:`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,dithering_fragment:`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,dithering_pars_fragment:`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,roughnessmap_fragment:`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,roughnessmap_pars_fragment:`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,shadowmap_pars_fragment:`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,shadowmap_pars_vertex:`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,shadowmap_vertex:`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,shadowmask_pars_fragment:`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,skinbase_vertex:`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,skinning_pars_vertex:`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,skinning_vertex:`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,skinnormal_vertex:`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,specularmap_fragment:`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,specularmap_pars_fragment:`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,tonemapping_fragment:`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,tonemapping_pars_fragment:`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,transmission_fragment:`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,transmission_pars_fragment:`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,uv_pars_fragment:`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,uv_pars_vertex:`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,uv_vertex:`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,worldpos_vertex:`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,background_vert:`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,background_frag:`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,backgroundCube_vert:`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,backgroundCube_frag:`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,cube_vert:`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,cube_frag:`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,depth_vert:`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,depth_frag:`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,distance_vert:`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,distance_frag:`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,equirect_vert:`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,equirect_frag:`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,linedashed_vert:`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,linedashed_frag:`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,meshbasic_vert:`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,meshbasic_frag:`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,meshlambert_vert:`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,meshlambert_frag:`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,meshmatcap_vert:`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,meshmatcap_frag:`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,meshnormal_vert:`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,meshnormal_frag:`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,meshphong_vert:`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,meshphong_frag:`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,meshphysical_vert:`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,meshphysical_frag:`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,meshtoon_vert:`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,meshtoon_frag:`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,points_vert:`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,points_frag:`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,shadow_vert:`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,shadow_frag:`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,sprite_vert:`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,sprite_frag:`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`},X={common:{diffuse:{value:new Or(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Y},alphaMap:{value:null},alphaMapTransform:{value:new Y},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Y}},envmap:{envMap:{value:null},envMapRotation:{value:new Y},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Y}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Y}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Y},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Y},normalScale:{value:new q(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Y},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Y}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Y}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Y}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Or(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Or(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Y},alphaTest:{value:0},uvTransform:{value:new Y}},sprite:{diffuse:{value:new Or(16777215)},opacity:{value:1},center:{value:new q(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Y},alphaMap:{value:null},alphaMapTransform:{value:new Y},alphaTest:{value:0}}},Po={basic:{uniforms:wa([X.common,X.specularmap,X.envmap,X.aomap,X.lightmap,X.fog]),vertexShader:No.meshbasic_vert,fragmentShader:No.meshbasic_frag},lambert:{uniforms:wa([X.common,X.specularmap,X.envmap,X.aomap,X.lightmap,X.emissivemap,X.bumpmap,X.normalmap,X.displacementmap,X.fog,X.lights,{emissive:{value:new Or(0)},envMapIntensity:{value:1}}]),vertexShader:No.meshlambert_vert,fragmentShader:No.meshlambert_frag},phong:{uniforms:wa([X.common,X.specularmap,X.envmap,X.aomap,X.lightmap,X.emissivemap,X.bumpmap,X.normalmap,X.displacementmap,X.fog,X.lights,{emissive:{value:new Or(0)},specular:{value:new Or(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:No.meshphong_vert,fragmentShader:No.meshphong_frag},standard:{uniforms:wa([X.common,X.envmap,X.aomap,X.lightmap,X.emissivemap,X.bumpmap,X.normalmap,X.displacementmap,X.roughnessmap,X.metalnessmap,X.fog,X.lights,{emissive:{value:new Or(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:No.meshphysical_vert,fragmentShader:No.meshphysical_frag},toon:{uniforms:wa([X.common,X.aomap,X.lightmap,X.emissivemap,X.bumpmap,X.normalmap,X.displacementmap,X.gradientmap,X.fog,X.lights,{emissive:{value:new Or(0)}}]),vertexShader:No.meshtoon_vert,fragmentShader:No.meshtoon_frag},matcap:{uniforms:wa([X.common,X.bumpmap,X.normalmap,X.displacementmap,X.fog,{matcap:{value:null}}]),vertexShader:No.meshmatcap_vert,fragmentShader:No.meshmatcap_frag},points:{uniforms:wa([X.points,X.fog]),vertexShader:No.points_vert,fragmentShader:No.points_frag},dashed:{uniforms:wa([X.common,X.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:No.linedashed_vert,fragmentShader:No.linedashed_frag},depth:{uniforms:wa([X.common,X.displacementmap]),vertexShader:No.depth_vert,fragmentShader:No.depth_frag},normal:{uniforms:wa([X.common,X.bumpmap,X.normalmap,X.displacementmap,{opacity:{value:1}}]),vertexShader:No.meshnormal_vert,fragmentShader:No.meshnormal_frag},sprite:{uniforms:wa([X.sprite,X.fog]),vertexShader:No.sprite_vert,fragmentShader:No.sprite_frag},background:{uniforms:{uvTransform:{value:new Y},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:No.background_vert,fragmentShader:No.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Y}},vertexShader:No.backgroundCube_vert,fragmentShader:No.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:No.cube_vert,fragmentShader:No.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:No.equirect_vert,fragmentShader:No.equirect_frag},distance:{uniforms:wa([X.common,X.displacementmap,{referencePosition:{value:new J},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:No.distance_vert,fragmentShader:No.distance_frag},shadow:{uniforms:wa([X.lights,X.fog,{color:{value:new Or(0)},opacity:{value:1}}]),vertexShader:No.shadow_vert,fragmentShader:No.shadow_frag}};Po.physical={uniforms:wa([Po.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Y},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Y},clearcoatNormalScale:{value:new q(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Y},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Y},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Y},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Y},sheen:{value:0},sheenColor:{value:new Or(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Y},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Y},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Y},transmissionSamplerSize:{value:new q},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Y},attenuationDistance:{value:0},attenuationColor:{value:new Or(0)},specularColor:{value:new Or(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Y},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Y},anisotropyVector:{value:new q},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Y}}]),vertexShader:No.meshphysical_vert,fragmentShader:No.meshphysical_frag};var Fo={r:0,b:0,g:0},Io=new qn,Lo=new Y;Lo.set(-1,0,0,0,1,0,0,0,1);function Ro(e,t,n,r,i,a){let o=new Or(0),s=i===!0?0:1,c,l,u=null,d=0,f=null;function p(e){let n=e.isScene===!0?e.background:null;if(n&&n.isTexture){let r=e.backgroundBlurriness>0;n=t.get(n,r)}return n}function m(t){let r=!1,i=p(t);i===null?g(o,s):i&&i.isColor&&(g(i,1),r=!0);let c=e.xr.getEnvironmentBlendMode();c===`additive`?n.buffers.color.setClear(0,0,0,1,a):c===`alpha-blend`&&n.buffers.color.setClear(0,0,0,0,a),(e.autoClear||r)&&(n.buffers.depth.setTest(!0),n.buffers.depth.setMask(!0),n.buffers.color.setMask(!0),e.clear(e.autoClearColor,e.autoClearDepth,e.autoClearStencil))}function h(t,n){let i=p(n);i&&i.isCubeTexture?(l===void 0&&(l=new Ji(new xa(1,1,1),new ja({name:`BackgroundCubeMaterial`,uniforms:Ca(Po.backgroundCube.uniforms),vertexShader:Po.backgroundCube.vertexShader,fragmentShader:Po.backgroundCube.fragmentShader,side:1,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute(`normal`),l.geometry.deleteAttribute(`uv`),l.onBeforeRender=function(e,t,n){this.matrixWorld.copyPosition(n.matrixWorld)},Object.defineProperty(l.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),r.update(l)),l.material.uniforms.envMap.value=i,l.material.uniforms.backgroundBlurriness.value=n.backgroundBlurriness,l.material.uniforms.backgroundIntensity.value=n.backgroundIntensity,l.material.uniforms.backgroundRotation.value.setFromMatrix4(Io.makeRotationFromEuler(n.backgroundRotation)).transpose(),i.isRenderTargetTexture===!1&&l.material.uniforms.backgroundRotation.value.premultiply(Lo),l.material.toneMapped=jn.getTransfer(i.colorSpace)!==Nt,(u!==i||d!==i.version||f!==e.toneMapping)&&(l.material.needsUpdate=!0,u=i,d=i.version,f=e.toneMapping),l.layers.enableAll(),t.unshift(l,l.geometry,l.material,0,0,null)):i&&i.isTexture&&(c===void 0&&(c=new Ji(new Sa(2,2),new ja({name:`BackgroundMaterial`,uniforms:Ca(Po.background.uniforms),vertexShader:Po.background.vertexShader,fragmentShader:Po.background.fragmentShader,side:0,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute(`normal`),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),r.update(c)),c.material.uniforms.t2D.value=i,c.material.uniforms.backgroundIntensity.value=n.backgroundIntensity,c.material.toneMapped=jn.getTransfer(i.colorSpace)!==Nt,i.matrixAutoUpdate===!0&&i.updateMatrix(),c.material.uniforms.uvTransform.value.copy(i.matrix),(u!==i||d!==i.version||f!==e.toneMapping)&&(c.material.needsUpdate=!0,u=i,d=i.version,f=e.toneMapping),c.layers.enableAll(),t.unshift(c,c.geometry,c.material,0,0,null))}function g(t,r){t.getRGB(Fo,Da(e)),n.buffers.color.setClear(Fo.r,Fo.g,Fo.b,r,a)}function _(){l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return o},setClearColor:function(e,t=1){o.set(e),s=t,g(o,s)},getClearAlpha:function(){return s},setClearAlpha:function(e){s=e,g(o,s)},render:m,addToRenderList:h,dispose:_}}function zo(e,t){let n=e.getParameter(e.MAX_VERTEX_ATTRIBS),r={},i=f(null),a=i,o=!1;function s(n,r,i,s,c){let u=!1,f=d(n,s,i,r);a!==f&&(a=f,l(a.object)),u=p(n,s,i,c),u&&m(n,s,i,c),c!==null&&t.update(c,e.ELEMENT_ARRAY_BUFFER),(u||o)&&(o=!1,b(n,r,i,s),c!==null&&e.bindBuffer(e.ELEMENT_ARRAY_BUFFER,t.get(c).buffer))}function c(){return e.createVertexArray()}function l(t){return e.bindVertexArray(t)}function u(t){return e.deleteVertexArray(t)}function d(e,t,n,i){let a=i.wireframe===!0,o=r[t.id];o===void 0&&(o={},r[t.id]=o);let s=e.isInstancedMesh===!0?e.id:0,l=o[s];l===void 0&&(l={},o[s]=l);let u=l[n.id];u===void 0&&(u={},l[n.id]=u);let d=u[a];return d===void 0&&(d=f(c()),u[a]=d),d}function f(e){let t=[],r=[],i=[];for(let e=0;e<n;e++)t[e]=0,r[e]=0,i[e]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:t,enabledAttributes:r,attributeDivisors:i,object:e,attributes:{},index:null}}function p(e,t,n,r){let i=a.attributes,o=t.attributes,s=0,c=n.getAttributes();for(let t in c)if(c[t].location>=0){let n=i[t],r=o[t];if(r===void 0&&(t===`instanceMatrix`&&e.instanceMatrix&&(r=e.instanceMatrix),t===`instanceColor`&&e.instanceColor&&(r=e.instanceColor)),n===void 0||n.attribute!==r||r&&n.data!==r.data)return!0;s++}return a.attributesNum!==s||a.index!==r}function m(e,t,n,r){let i={},o=t.attributes,s=0,c=n.getAttributes();for(let t in c)if(c[t].location>=0){let n=o[t];n===void 0&&(t===`instanceMatrix`&&e.instanceMatrix&&(n=e.instanceMatrix),t===`instanceColor`&&e.instanceColor&&(n=e.instanceColor));let r={};r.attribute=n,n&&n.data&&(r.data=n.data),i[t]=r,s++}a.attributes=i,a.attributesNum=s,a.index=r}function h(){let e=a.newAttributes;for(let t=0,n=e.length;t<n;t++)e[t]=0}function g(e){_(e,0)}function _(t,n){let r=a.newAttributes,i=a.enabledAttributes,o=a.attributeDivisors;r[t]=1,i[t]===0&&(e.enableVertexAttribArray(t),i[t]=1),o[t]!==n&&(e.vertexAttribDivisor(t,n),o[t]=n)}function v(){let t=a.newAttributes,n=a.enabledAttributes;for(let r=0,i=n.length;r<i;r++)n[r]!==t[r]&&(e.disableVertexAttribArray(r),n[r]=0)}function y(t,n,r,i,a,o,s){s===!0?e.vertexAttribIPointer(t,n,r,a,o):e.vertexAttribPointer(t,n,r,i,a,o)}function b(n,r,i,a){h();let o=a.attributes,s=i.getAttributes(),c=r.defaultAttributeValues;for(let r in s){let i=s[r];if(i.location>=0){let s=o[r];if(s===void 0&&(r===`instanceMatrix`&&n.instanceMatrix&&(s=n.instanceMatrix),r===`instanceColor`&&n.instanceColor&&(s=n.instanceColor)),s!==void 0){let r=s.normalized,o=s.itemSize,c=t.get(s);if(c===void 0)continue;let l=c.buffer,u=c.type,d=c.bytesPerElement,f=u===e.INT||u===e.UNSIGNED_INT||s.gpuType===1013;if(s.isInterleavedBufferAttribute){let t=s.data,c=t.isInterleavedBuffer===!0?t.stride:t.itemSize,p=s.offset;if(t.isInstancedInterleavedBuffer||t.isInstancedBufferAttribute){for(let e=0;e<i.locationSize;e++)_(i.location+e,t.meshPerAttribute);n.isInstancedMesh!==!0&&a._maxInstanceCount===void 0&&(a._maxInstanceCount=t.meshPerAttribute*t.count)}else for(let e=0;e<i.locationSize;e++)g(i.location+e);e.bindBuffer(e.ARRAY_BUFFER,l);for(let e=0;e<i.locationSize;e++)y(i.location+e,o/i.locationSize,u,r,c*d,(p+o/i.locationSize*e)*d,f)}else{if(s.isInstancedBufferAttribute){for(let e=0;e<i.locationSize;e++)_(i.location+e,s.meshPerAttribute);n.isInstancedMesh!==!0&&a._maxInstanceCount===void 0&&(a._maxInstanceCount=s.meshPerAttribute*s.count)}else for(let e=0;e<i.locationSize;e++)g(i.location+e);e.bindBuffer(e.ARRAY_BUFFER,l);for(let e=0;e<i.locationSize;e++)y(i.location+e,o/i.locationSize,u,r,o*d,o/i.locationSize*e*d,f)}}else if(c!==void 0){let t=c[r];if(t!==void 0)switch(t.length){case 2:e.vertexAttrib2fv(i.location,t);break;case 3:e.vertexAttrib3fv(i.location,t);break;case 4:e.vertexAttrib4fv(i.location,t);break;default:e.vertexAttrib1fv(i.location,t)}}}}v()}function x(){T();for(let e in r){let t=r[e];for(let e in t){let n=t[e];for(let e in n){let t=n[e];for(let e in t)u(t[e].object),delete t[e];delete n[e]}}delete r[e]}}function S(e){if(r[e.id]===void 0)return;let t=r[e.id];for(let e in t){let n=t[e];for(let e in n){let t=n[e];for(let e in t)u(t[e].object),delete t[e];delete n[e]}}delete r[e.id]}function C(e){for(let t in r){let n=r[t];for(let t in n){let r=n[t];if(r[e.id]===void 0)continue;let i=r[e.id];for(let e in i)u(i[e].object),delete i[e];delete r[e.id]}}}function w(e){for(let t in r){let n=r[t],i=e.isInstancedMesh===!0?e.id:0,a=n[i];if(a!==void 0){for(let e in a){let t=a[e];for(let e in t)u(t[e].object),delete t[e];delete a[e]}delete n[i],Object.keys(n).length===0&&delete r[t]}}}function T(){E(),o=!0,a!==i&&(a=i,l(a.object))}function E(){i.geometry=null,i.program=null,i.wireframe=!1}return{setup:s,reset:T,resetDefaultState:E,dispose:x,releaseStatesOfGeometry:S,releaseStatesOfObject:w,releaseStatesOfProgram:C,initAttributes:h,enableAttribute:g,disableUnusedAttributes:v}}function Bo(e,t,n){let r;function i(e){r=e}function a(t,i){e.drawArrays(r,t,i),n.update(i,r,1)}function o(t,i,a){a!==0&&(e.drawArraysInstanced(r,t,i,a),n.update(i,r,a))}function s(e,i,a){if(a===0)return;t.get(`WEBGL_multi_draw`).multiDrawArraysWEBGL(r,e,0,i,0,a);let o=0;for(let e=0;e<a;e++)o+=i[e];n.update(o,r,1)}this.setMode=i,this.render=a,this.renderInstances=o,this.renderMultiDraw=s}function Vo(e,t,n,r){let i;function a(){if(i!==void 0)return i;if(t.has(`EXT_texture_filter_anisotropic`)===!0){let n=t.get(`EXT_texture_filter_anisotropic`);i=e.getParameter(n.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else i=0;return i}function o(t){return t===1023||r.convert(t)===e.getParameter(e.IMPLEMENTATION_COLOR_READ_FORMAT)}function s(n){let i=n===1016&&(t.has(`EXT_color_buffer_half_float`)||t.has(`EXT_color_buffer_float`));return!(n!==1009&&n!==1015&&!i&&r.convert(n)!==e.getParameter(e.IMPLEMENTATION_COLOR_READ_TYPE))}function c(t){if(t===`highp`){if(e.getShaderPrecisionFormat(e.VERTEX_SHADER,e.HIGH_FLOAT).precision>0&&e.getShaderPrecisionFormat(e.FRAGMENT_SHADER,e.HIGH_FLOAT).precision>0)return`highp`;t=`mediump`}return t===`mediump`&&e.getShaderPrecisionFormat(e.VERTEX_SHADER,e.MEDIUM_FLOAT).precision>0&&e.getShaderPrecisionFormat(e.FRAGMENT_SHADER,e.MEDIUM_FLOAT).precision>0?`mediump`:`lowp`}let l=n.precision===void 0?`highp`:n.precision,u=c(l);u!==l&&(G(`WebGLRenderer:`,l,`not supported, using`,u,`instead.`),l=u);let d=n.reversedDepthBuffer===!0&&t.has(`EXT_clip_control`),f=n.logarithmicDepthBuffer===!0&&d===!1;n.reversedDepthBuffer===!0&&d===!1&&G(`WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer.`),n.logarithmicDepthBuffer===!0&&d===!0&&G(`WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.`);let p=e.getParameter(e.MAX_TEXTURE_IMAGE_UNITS),m=e.getParameter(e.MAX_VERTEX_TEXTURE_IMAGE_UNITS),h=e.getParameter(e.MAX_TEXTURE_SIZE),g=e.getParameter(e.MAX_CUBE_MAP_TEXTURE_SIZE),_=e.getParameter(e.MAX_VERTEX_ATTRIBS),v=e.getParameter(e.MAX_VERTEX_UNIFORM_VECTORS),y=e.getParameter(e.MAX_VARYING_VECTORS),b=e.getParameter(e.MAX_FRAGMENT_UNIFORM_VECTORS),x=e.getParameter(e.MAX_SAMPLES),S=e.getParameter(e.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:a,getMaxPrecision:c,textureFormatReadable:o,textureTypeReadable:s,precision:l,logarithmicDepthBuffer:f,reversedDepthBuffer:d,maxTextures:p,maxVertexTextures:m,maxTextureSize:h,maxCubemapSize:g,maxAttributes:_,maxVertexUniforms:v,maxVaryings:y,maxFragmentUniforms:b,maxSamples:x,samples:S}}function Ho(e){let t=this,n=null,r=0,i=!1,a=!1,o=new Oi,s=new Y,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(e,t){let n=e.length!==0||t||r!==0||i;return i=t,r=e.length,n},this.beginShadows=function(){a=!0,u(null)},this.endShadows=function(){a=!1},this.setGlobalState=function(e,t){n=u(e,t,0)},this.setState=function(t,o,s){let d=t.clippingPlanes,f=t.clipIntersection,p=t.clipShadows,m=e.get(t);if(!i||d===null||d.length===0||a&&!p)a?u(null):l();else{let e=a?0:r,t=e*4,i=m.clippingState||null;c.value=i,i=u(d,o,t,s);for(let e=0;e!==t;++e)i[e]=n[e];m.clippingState=i,this.numIntersection=f?this.numPlanes:0,this.numPlanes+=e}};function l(){c.value!==n&&(c.value=n,c.needsUpdate=r>0),t.numPlanes=r,t.numIntersection=0}function u(e,n,r,i){let a=e===null?0:e.length,l=null;if(a!==0){if(l=c.value,i!==!0||l===null){let t=r+a*4,i=n.matrixWorldInverse;s.getNormalMatrix(i),(l===null||l.length<t)&&(l=new Float32Array(t));for(let t=0,n=r;t!==a;++t,n+=4)o.copy(e[t]).applyMatrix4(i,s),o.normal.toArray(l,n),l[n+3]=o.constant}c.value=l,c.needsUpdate=!0}return t.numPlanes=a,t.numIntersection=0,l}}var Uo=class extends Wn{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},r=[n,n,n,n,n,n];this.texture=new _a(r),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},r=new xa(5,5,5),i=new ja({name:`CubemapFromEquirect`,uniforms:Ca(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:1,blending:0});i.uniforms.tEquirect.value=t;let a=new Ji(r,i),o=t.minFilter;return t.minFilter===1008&&(t.minFilter=R),new po(1,10,this).update(e,a),t.minFilter=o,a.geometry.dispose(),a.material.dispose(),this}clear(e,t=!0,n=!0,r=!0){let i=e.getRenderTarget();for(let i=0;i<6;i++)e.setRenderTarget(this,i),e.clear(t,n,r);e.setRenderTarget(i)}},Wo=256,Go=3,Ko=20,qo=256,Jo=16,Yo=3,Xo=new J,Zo=new Or,Qo=class e{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new po(1,10,null),this._boxMesh=new Ji(new xa(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,r=100,i={}){let{size:a=256,position:o=Xo}=i,s=this._renderer;this._setSize(a);let c=this._allocateTarget(),l=this._getSourceTarget(!0);t>0&&(l.texture.mipmapsAutoUpdate=!1);let u=s.autoClear,d=s.autoClearColor,f=s.autoClearDepth,p=s.autoClearStencil,m=e.background;s.autoClear=!0,s.autoClearColor=!0,s.autoClearDepth=!0,s.autoClearStencil=!0,m===null&&(e.background=s.getClearColor(Zo));let h=new po(n,r,l);return h.position.copy(o),h.update(s,e),s.autoClear=u,s.autoClearColor=d,s.autoClearDepth=f,s.autoClearStencil=p,e.background=m,t>0&&(l.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=as(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=is(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(Wo,vn(e))}_fromTexture(e,t){e.mapping===301||e.mapping===302?this._setSize(e.image.length===0?Wo:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=$o(e,!1,!1),n=Math.log2(e)-Go;for(let r=0;r<=n;r++)t.texture.mipmaps.push({width:e>>r,height:e>>r});return t.texture.name=`PMREM`,t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=$o(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let r=this._boxMesh,i=this._cubeCamera;r.material=n,i.renderTarget=e,i.activeMipmapLevel=t;let a=e.width>>t;e.viewport.set(0,0,a,a),i.update(this._renderer,r),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===301||e.mapping===302?(this._cubemapMaterial===null&&(this._cubemapMaterial=as()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=is()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=ts(),this._integrationMaterial=ns());let n=this._cubeSize,r=t.texture.mipmaps.length-1,i=this._ggxMaterial.uniforms;i.envMap.value=this._sourceTarget.texture;let a=this._integrationMaterial.uniforms;a.envMap.value=this._sourceTarget.texture,a.sourceLod.value=Math.log2(n/Jo);for(let o=0;o<=r;o++){let s=e.lodToRoughness(o,r);if(o>r-Yo)a.roughness.value=s,this._renderCube(t,o,this._integrationMaterial);else{let e=s>0?Math.log2(n)+.5*Math.log2(6/(qo*s**4))+.5:0;i.roughness.value=s,i.lodBias.value=e,this._renderCube(t,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=rs());let n=this._blurMaterial,r=n.uniforms,i=this._sourceTarget;r.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,r.envMap.value=i.texture,this._renderCube(e,0,n),r.envMap.value=e.texture,this._renderCube(i,0,n)}};function $o(e,t,n){return new Uo(e,{minFilter:B,generateMipmaps:t,type:Ee,colorSpace:jt,depthBuffer:n})}function es(e,t,n){return new ja({name:e,uniforms:t,vertexShader:No.cube_vert,fragmentShader:n,side:1,blending:0,depthTest:!1,depthWrite:!1})}function ts(){return es(`PMREMGGXConvolution`,{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${qo}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function ns(){return es(`PMREMGGXIntegration`,{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Jo}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function rs(){return es(`PMREMSphericalGaussianBlur`,{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${Ko}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function is(){return es(`PMREMEquirectangularToCubemap`,{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function as(){return es(`PMREMCubemapToCubemap`,{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function os(e){let t=new WeakMap,n=new WeakMap,r=null;function i(e,t=!1){return e==null?null:t?o(e):a(e)}function a(n){if(n&&n.isTexture){let r=n.mapping;if(r===303||r===304){if(t.has(n)){let e=t.get(n).texture;return s(e,n.mapping)}{let r=n.image;if(r&&r.height>0){let i=new Uo(r.height);return i.fromEquirectangularTexture(e,n),t.set(n,i),n.addEventListener(`dispose`,l),s(i.texture,n.mapping)}return null}}}return n}function o(t){if(t&&t.isTexture&&t.isPMREMTexture!==!0){let i=t.mapping,a=i===303||i===304,o=i===301||i===302;if(a||o){let i=n.get(t),s=i===void 0?0:i.texture.pmremVersion;if(t.isRenderTargetTexture&&t.pmremVersion!==s)return r===null&&(r=new Qo(e)),i=a?r.fromEquirectangular(t,i):r.fromCubemap(t,i),i.texture.pmremVersion=t.pmremVersion,n.set(t,i),i.texture;if(i!==void 0)return i.texture;{let s=t.image;return a&&s&&s.height>0||o&&s&&c(s)?(r===null&&(r=new Qo(e)),i=a?r.fromEquirectangular(t):r.fromCubemap(t),i.texture.pmremVersion=t.pmremVersion,n.set(t,i),t.addEventListener(`dispose`,u),i.texture):null}}}return t}function s(e,t){return t===303?e.mapping=301:t===304&&(e.mapping=302),e}function c(e){let t=0;for(let n=0;n<6;n++)e[n]!==void 0&&t++;return t===6}function l(e){let n=e.target;n.removeEventListener(`dispose`,l);let r=t.get(n);r!==void 0&&(t.delete(n),r.dispose())}function u(e){let t=e.target;t.removeEventListener(`dispose`,u);let r=n.get(t);r!==void 0&&(n.delete(t),r.dispose())}function d(){t=new WeakMap,n=new WeakMap,r!==null&&(r.dispose(),r=null)}return{get:i,dispose:d}}function ss(e){let t={};function n(n){if(t[n]!==void 0)return t[n];let r=e.getExtension(n);return t[n]=r,r}return{has:function(e){return n(e)!==null},init:function(){n(`EXT_color_buffer_float`),n(`WEBGL_clip_cull_distance`),n(`OES_texture_float_linear`),n(`EXT_color_buffer_half_float`),n(`WEBGL_multisampled_render_to_texture`),n(`WEBGL_render_shared_exponent`)},get:function(e){let t=n(e);return t===null&&Gt(`WebGLRenderer: `+e+` extension not supported.`),t}}}function cs(e,t,n,r){let i={},a=new WeakMap,o=new FinalizationRegistry(e=>delete i[e]);function s(e){c(e.target)}function c(e){e.index!==null&&t.remove(e.index);for(let n in e.attributes)t.remove(e.attributes[n]);e.removeEventListener(`dispose`,s),delete i[e.id],o.unregister(e);let c=a.get(e);c&&(t.remove(c),a.delete(e)),r.releaseStatesOfGeometry(e),e.isInstancedBufferGeometry===!0&&delete e._maxInstanceCount,n.memory.geometries--}function l(e,t){return i[t.id]===void 0&&(t.addEventListener(`dispose`,s),i[t.id]=new WeakRef(t),o.register(t,t.id,t),n.memory.geometries++),t}function u(n){let r=n.attributes;for(let n in r)t.update(r[n],e.ARRAY_BUFFER)}function d(e){let n=e.index,r=e.attributes.position,i=0;if(r===void 0)return;let o=n===null?r.array.length/3-1:n.array.length,s=new(r.count>=65535?di:ui)(Math.ceil(o/3)*6,1),c=s.array;if(n!==null){let e=n.array;i=n.version;for(let t=0,n=0;t<o;t+=3){let r=e[t+0],i=e[t+1],a=e[t+2];c[n++]=r,c[n++]=i,c[n++]=i,c[n++]=a,c[n++]=a,c[n++]=r}}else{i=r.version;for(let e=0,t=0;e<o;e+=3){let n=e+0,r=e+1,i=e+2;c[t++]=n,c[t++]=r,c[t++]=r,c[t++]=i,c[t++]=i,c[t++]=n}}s.version=i;let l=a.get(e);l&&t.remove(l),a.set(e,s)}function f(e){let t=a.get(e);if(t){let n=e.index;n!==null&&t.version<n.version&&d(e)}else d(e);return a.get(e)}function p(){for(let e in i){let t=i[e].deref();t!==void 0&&c(t)}}return{get:l,update:u,getWireframeAttribute:f,dispose:p}}function ls(e,t,n){let r;function i(e){r=e}let a,o;function s(e){a=e.type,o=e.bytesPerElement}function c(t,i){e.drawElements(r,i,a,t*o),n.update(i,r,1)}function l(t,i,s){s!==0&&(e.drawElementsInstanced(r,i,a,t*o,s),n.update(i,r,s))}function u(e,i,o){if(o===0)return;t.get(`WEBGL_multi_draw`).multiDrawElementsWEBGL(r,i,0,a,e,0,o);let s=0;for(let e=0;e<o;e++)s+=i[e];n.update(s,r,1)}this.setMode=i,this.setIndex=s,this.render=c,this.renderInstances=l,this.renderMultiDraw=u}function us(e){let t={geometries:0,textures:0},n={frame:0,calls:0,triangles:0,points:0,lines:0};function r(t,r,i){switch(n.calls++,r){case e.TRIANGLES:n.triangles+=t/3*i;break;case e.LINES:n.lines+=t/2*i;break;case e.LINE_STRIP:n.lines+=i*(t-1);break;case e.LINE_LOOP:n.lines+=i*t;break;case e.POINTS:n.points+=i*t;break;default:K(`WebGLInfo: Unknown draw mode:`,r)}}function i(){n.calls=0,n.triangles=0,n.points=0,n.lines=0}return{memory:t,render:n,programs:null,autoReset:!0,reset:i,update:r}}function ds(e,t,n){let r=new WeakMap,i=new Hn;function a(a,o,s){let c=a.morphTargetInfluences,l=o.morphAttributes.position||o.morphAttributes.normal||o.morphAttributes.color,u=l===void 0?0:l.length,d=r.get(o);if(d===void 0||d.count!==u){d!==void 0&&d.texture.dispose();let e=o.morphAttributes.position!==void 0,n=o.morphAttributes.normal!==void 0,a=o.morphAttributes.color!==void 0,s=o.morphAttributes.position||[],c=o.morphAttributes.normal||[],l=o.morphAttributes.color||[],f=0;e===!0&&(f=1),n===!0&&(f=2),a===!0&&(f=3);let p=o.attributes.position.count*f,m=1;p>t.maxTextureSize&&(m=Math.ceil(p/t.maxTextureSize),p=t.maxTextureSize);let h=new Float32Array(p*m*4*u),g=new Gn(h,p,m,u);g.type=Te,g.needsUpdate=!0;let _=f*4;for(let t=0;t<u;t++){let r=s[t],o=c[t],u=l[t],d=p*m*4*t;for(let t=0;t<r.count;t++){let s=t*_;e===!0&&(i.fromBufferAttribute(r,t),h[d+s+0]=i.x,h[d+s+1]=i.y,h[d+s+2]=i.z,h[d+s+3]=0),n===!0&&(i.fromBufferAttribute(o,t),h[d+s+4]=i.x,h[d+s+5]=i.y,h[d+s+6]=i.z,h[d+s+7]=0),a===!0&&(i.fromBufferAttribute(u,t),h[d+s+8]=i.x,h[d+s+9]=i.y,h[d+s+10]=i.z,h[d+s+11]=u.itemSize===4?i.w:1)}}d={count:u,texture:g,size:new q(p,m)},r.set(o,d);function v(){g.dispose(),r.delete(o),o.removeEventListener(`dispose`,v)}o.addEventListener(`dispose`,v)}if(a.isInstancedMesh===!0&&a.morphTexture!==null)s.getUniforms().setValue(e,`morphTexture`,a.morphTexture,n);else{let t=0;for(let e=0;e<c.length;e++)t+=c[e];let n=o.morphTargetsRelative?1:1-t;s.getUniforms().setValue(e,`morphTargetBaseInfluence`,n),s.getUniforms().setValue(e,`morphTargetInfluences`,c)}s.getUniforms().setValue(e,`morphTargetsTexture`,d.texture,n),s.getUniforms().setValue(e,`morphTargetsTextureSize`,d.size)}return{update:a}}function fs(e,t,n,r,i){let a=new WeakMap;function o(r){let o=i.render.frame,s=r.geometry,l=t.get(r,s);if(a.get(l)!==o&&(t.update(l),a.set(l,o)),r.isInstancedMesh&&(r.hasEventListener(`dispose`,c)===!1&&r.addEventListener(`dispose`,c),a.get(r)!==o&&(n.update(r.instanceMatrix,e.ARRAY_BUFFER),r.instanceColor!==null&&n.update(r.instanceColor,e.ARRAY_BUFFER),a.set(r,o))),r.isSkinnedMesh){let e=r.skeleton;a.get(e)!==o&&(e.update(),a.set(e,o))}return l}function s(){a=new WeakMap}function c(e){let t=e.target;t.removeEventListener(`dispose`,c),r.releaseStatesOfObject(t),n.remove(t.instanceMatrix),t.instanceColor!==null&&n.remove(t.instanceColor)}return{update:o,dispose:s}}var ps={1:`LINEAR_TONE_MAPPING`,2:`REINHARD_TONE_MAPPING`,3:`CINEON_TONE_MAPPING`,4:`ACES_FILMIC_TONE_MAPPING`,6:`AGX_TONE_MAPPING`,7:`NEUTRAL_TONE_MAPPING`,5:`CUSTOM_TONE_MAPPING`};function ms(e,t,n,r,i,a){let o=new Wn(t,n,{type:e,depthBuffer:i,stencilBuffer:a,samples:r?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),s=null,c=null,l=null,u=new wi;u.setAttribute(`position`,new fi([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute(`uv`,new fi([0,2,0,0,2,0],2));let d=new Ma({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),f=new Ji(u,d),p=new lo(-1,1,1,-1,0,1),m=null,h=null,g=!1,_,v=null,y=[],b=!1;this.setSize=function(e,t){o.setSize(e,t),s!==null&&s.setSize(e,t),c!==null&&c.setSize(e,t);for(let n=0;n<y.length;n++){let r=y[n];r.setSize&&r.setSize(e,t)}},this.setEffects=function(e){y=e,b=y.length>0&&y[0].isRenderPass===!0;let t=o.width,n=o.height;y.length>0&&s===null&&(s=new Wn(t,n,{type:Ee,depthBuffer:!1,stencilBuffer:!1}),c=new Wn(t,n,{type:Ee,depthBuffer:!1,stencilBuffer:!1}));let r=i===!0&&y.some(e=>e.needsDepthTexture===!0);r!==(o.depthTexture!==null)&&(r===!0&&l===null&&(l=new va(t,n),a===!0&&(l.format=Pe,l.type=ke)),o.dispose(),o.depthTexture=r?l:null,o.resolveDepthBuffer=r,o.storeMultisampledDepthBuffer=r);for(let e=0;e<y.length;e++){let i=y[e];i.setSize&&i.setSize(t,n),r&&i.needsDepthTexture===!0&&i.setDepthTexture&&i.setDepthTexture(l)}},this.begin=function(e,t){if(g||e.toneMapping===0&&y.length===0)return!1;if(v=t,t!==null){let e=t.width,n=t.height;(o.width!==e||o.height!==n)&&this.setSize(e,n)}return b===!1&&e.setRenderTarget(o),_=e.toneMapping,e.toneMapping=0,!0},this.hasRenderPass=function(){return b},this.end=function(e,t){e.toneMapping=_,g=!0;let n=o,r=s;for(let i=0;i<y.length;i++){let a=y[i];a.enabled!==!1&&(a.render(e,r,n,t),a.needsSwap!==!1&&(n=r,r=r===s?c:s))}if(m!==e.outputColorSpace||h!==e.toneMapping){m=e.outputColorSpace,h=e.toneMapping,d.defines={},jn.getTransfer(m)===`srgb`&&(d.defines.SRGB_TRANSFER=``);let t=ps[h];t&&(d.defines[t]=``),d.needsUpdate=!0}d.uniforms.tDiffuse.value=n.texture,e.setRenderTarget(v),e.render(f,p),v=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),s!==null&&s.dispose(),c!==null&&c.dispose(),u.dispose(),d.dispose()}}var hs=new Vn,gs=new va(1,1),_s=new ya(1),vs=new Gn,ys=new Kn,bs=new _a,xs=[],Ss=[],Cs=new Float32Array(16),ws=new Float32Array(9),Ts=new Float32Array(4);function Es(e,t,n){let r=e[0];if(r<=0||r>0)return e;let i=t*n,a=xs[i];if(a===void 0&&(a=new Float32Array(i),xs[i]=a),t!==0){r.toArray(a,0);for(let r=1,i=0;r!==t;++r)i+=n,e[r].toArray(a,i)}return a}function Ds(e,t){if(e.length!==t.length)return!1;for(let n=0,r=e.length;n<r;n++)if(e[n]!==t[n])return!1;return!0}function Os(e,t){for(let n=0,r=t.length;n<r;n++)e[n]=t[n]}function ks(e,t){let n=Ss[t];n===void 0&&(n=new Int32Array(t),Ss[t]=n);for(let r=0;r!==t;++r)n[r]=e.allocateTextureUnit();return n}function As(e,t){let n=this.cache;n[0]!==t&&(e.uniform1f(this.addr,t),n[0]=t)}function js(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y)&&(e.uniform2f(this.addr,t.x,t.y),n[0]=t.x,n[1]=t.y);else{if(Ds(n,t))return;e.uniform2fv(this.addr,t),Os(n,t)}}function Ms(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y||n[2]!==t.z)&&(e.uniform3f(this.addr,t.x,t.y,t.z),n[0]=t.x,n[1]=t.y,n[2]=t.z);else if(t.r!==void 0)(n[0]!==t.r||n[1]!==t.g||n[2]!==t.b)&&(e.uniform3f(this.addr,t.r,t.g,t.b),n[0]=t.r,n[1]=t.g,n[2]=t.b);else{if(Ds(n,t))return;e.uniform3fv(this.addr,t),Os(n,t)}}function Ns(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y||n[2]!==t.z||n[3]!==t.w)&&(e.uniform4f(this.addr,t.x,t.y,t.z,t.w),n[0]=t.x,n[1]=t.y,n[2]=t.z,n[3]=t.w);else{if(Ds(n,t))return;e.uniform4fv(this.addr,t),Os(n,t)}}function Ps(e,t){let n=this.cache,r=t.elements;if(r===void 0){if(Ds(n,t))return;e.uniformMatrix2fv(this.addr,!1,t),Os(n,t)}else{if(Ds(n,r))return;Ts.set(r),e.uniformMatrix2fv(this.addr,!1,Ts),Os(n,r)}}function Fs(e,t){let n=this.cache,r=t.elements;if(r===void 0){if(Ds(n,t))return;e.uniformMatrix3fv(this.addr,!1,t),Os(n,t)}else{if(Ds(n,r))return;ws.set(r),e.uniformMatrix3fv(this.addr,!1,ws),Os(n,r)}}function Is(e,t){let n=this.cache,r=t.elements;if(r===void 0){if(Ds(n,t))return;e.uniformMatrix4fv(this.addr,!1,t),Os(n,t)}else{if(Ds(n,r))return;Cs.set(r),e.uniformMatrix4fv(this.addr,!1,Cs),Os(n,r)}}function Ls(e,t){let n=this.cache;n[0]!==t&&(e.uniform1i(this.addr,t),n[0]=t)}function Rs(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y)&&(e.uniform2i(this.addr,t.x,t.y),n[0]=t.x,n[1]=t.y);else{if(Ds(n,t))return;e.uniform2iv(this.addr,t),Os(n,t)}}function zs(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y||n[2]!==t.z)&&(e.uniform3i(this.addr,t.x,t.y,t.z),n[0]=t.x,n[1]=t.y,n[2]=t.z);else{if(Ds(n,t))return;e.uniform3iv(this.addr,t),Os(n,t)}}function Bs(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y||n[2]!==t.z||n[3]!==t.w)&&(e.uniform4i(this.addr,t.x,t.y,t.z,t.w),n[0]=t.x,n[1]=t.y,n[2]=t.z,n[3]=t.w);else{if(Ds(n,t))return;e.uniform4iv(this.addr,t),Os(n,t)}}function Vs(e,t){let n=this.cache;n[0]!==t&&(e.uniform1ui(this.addr,t),n[0]=t)}function Hs(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y)&&(e.uniform2ui(this.addr,t.x,t.y),n[0]=t.x,n[1]=t.y);else{if(Ds(n,t))return;e.uniform2uiv(this.addr,t),Os(n,t)}}function Us(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y||n[2]!==t.z)&&(e.uniform3ui(this.addr,t.x,t.y,t.z),n[0]=t.x,n[1]=t.y,n[2]=t.z);else{if(Ds(n,t))return;e.uniform3uiv(this.addr,t),Os(n,t)}}function Ws(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y||n[2]!==t.z||n[3]!==t.w)&&(e.uniform4ui(this.addr,t.x,t.y,t.z,t.w),n[0]=t.x,n[1]=t.y,n[2]=t.z,n[3]=t.w);else{if(Ds(n,t))return;e.uniform4uiv(this.addr,t),Os(n,t)}}function Gs(e){return e.version===0&&(e.compareFunction=519,e.needsUpdate=!0),e}function Ks(e,t,n){let r=this.cache,i=n.allocateTextureUnit();r[0]!==i&&(e.uniform1i(this.addr,i),r[0]=i);let a;a=this.type===e.SAMPLER_2D_SHADOW?Gs(gs):hs,n.setTexture2D(t||a,i)}function qs(e,t,n){let r=this.cache,i=n.allocateTextureUnit();r[0]!==i&&(e.uniform1i(this.addr,i),r[0]=i),n.setTexture3D(t||ys,i)}function Js(e,t,n){let r=this.cache,i=n.allocateTextureUnit();r[0]!==i&&(e.uniform1i(this.addr,i),r[0]=i);let a;a=this.type===e.SAMPLER_CUBE_SHADOW?Gs(_s):bs,n.setTextureCube(t||a,i)}function Ys(e,t,n){let r=this.cache,i=n.allocateTextureUnit();r[0]!==i&&(e.uniform1i(this.addr,i),r[0]=i),n.setTexture2DArray(t||vs,i)}function Xs(e){switch(e){case 5126:return As;case 35664:return js;case 35665:return Ms;case 35666:return Ns;case 35674:return Ps;case 35675:return Fs;case 35676:return Is;case 5124:case 35670:return Ls;case 35667:case 35671:return Rs;case 35668:case 35672:return zs;case 35669:case 35673:return Bs;case 5125:return Vs;case 36294:return Hs;case 36295:return Us;case 36296:return Ws;case 35678:case 36198:case 36298:case 36306:case 35682:return Ks;case 35679:case 36299:case 36307:return qs;case 35680:case 36300:case 36308:case 36293:return Js;case 36289:case 36303:case 36311:case 36292:return Ys}}function Zs(e,t){e.uniform1fv(this.addr,t)}function Qs(e,t){let n=Es(t,this.size,2);e.uniform2fv(this.addr,n)}function $s(e,t){let n=Es(t,this.size,3);e.uniform3fv(this.addr,n)}function ec(e,t){let n=Es(t,this.size,4);e.uniform4fv(this.addr,n)}function tc(e,t){let n=Es(t,this.size,4);e.uniformMatrix2fv(this.addr,!1,n)}function nc(e,t){let n=Es(t,this.size,9);e.uniformMatrix3fv(this.addr,!1,n)}function rc(e,t){let n=Es(t,this.size,16);e.uniformMatrix4fv(this.addr,!1,n)}function ic(e,t){e.uniform1iv(this.addr,t)}function ac(e,t){e.uniform2iv(this.addr,t)}function oc(e,t){e.uniform3iv(this.addr,t)}function sc(e,t){e.uniform4iv(this.addr,t)}function cc(e,t){e.uniform1uiv(this.addr,t)}function lc(e,t){e.uniform2uiv(this.addr,t)}function uc(e,t){e.uniform3uiv(this.addr,t)}function dc(e,t){e.uniform4uiv(this.addr,t)}function fc(e,t,n){let r=this.cache,i=t.length,a=ks(n,i);Ds(r,a)||(e.uniform1iv(this.addr,a),Os(r,a));let o;o=this.type===e.SAMPLER_2D_SHADOW?Gs(gs):hs;for(let e=0;e!==i;++e)n.setTexture2D(t[e]||o,a[e])}function pc(e,t,n){let r=this.cache,i=t.length,a=ks(n,i);Ds(r,a)||(e.uniform1iv(this.addr,a),Os(r,a));for(let e=0;e!==i;++e)n.setTexture3D(t[e]||ys,a[e])}function mc(e,t,n){let r=this.cache,i=t.length,a=ks(n,i);Ds(r,a)||(e.uniform1iv(this.addr,a),Os(r,a));let o;o=this.type===e.SAMPLER_CUBE_SHADOW?Gs(_s):bs;for(let e=0;e!==i;++e)n.setTextureCube(t[e]||o,a[e])}function hc(e,t,n){let r=this.cache,i=t.length,a=ks(n,i);Ds(r,a)||(e.uniform1iv(this.addr,a),Os(r,a));for(let e=0;e!==i;++e)n.setTexture2DArray(t[e]||vs,a[e])}function gc(e){switch(e){case 5126:return Zs;case 35664:return Qs;case 35665:return $s;case 35666:return ec;case 35674:return tc;case 35675:return nc;case 35676:return rc;case 5124:case 35670:return ic;case 35667:case 35671:return ac;case 35668:case 35672:return oc;case 35669:case 35673:return sc;case 5125:return cc;case 36294:return lc;case 36295:return uc;case 36296:return dc;case 35678:case 36198:case 36298:case 36306:case 35682:return fc;case 35679:case 36299:case 36307:return pc;case 35680:case 36300:case 36308:case 36293:return mc;case 36289:case 36303:case 36311:case 36292:return hc}}var _c=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=Xs(t.type)}},vc=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=gc(t.type)}},yc=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let r=this.seq;for(let i=0,a=r.length;i!==a;++i){let a=r[i];a.setValue(e,t[a.id],n)}}},bc=/(\w+)(\])?(\[|\.)?/g;function xc(e,t){e.seq.push(t),e.map[t.id]=t}function Sc(e,t,n){let r=e.name,i=r.length;for(bc.lastIndex=0;;){let a=bc.exec(r),o=bc.lastIndex,s=a[1],c=a[2]===`]`,l=a[3];if(c&&(s|=0),l===void 0||l===`[`&&o+2===i){xc(n,l===void 0?new _c(s,e,t):new vc(s,e,t));break}{let e=n.map[s];e===void 0&&(e=new yc(s),xc(n,e)),n=e}}}var Cc=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let r=0;r<n;++r){let n=e.getActiveUniform(t,r);Sc(n,e.getUniformLocation(t,n.name),this)}let r=[],i=[];for(let t of this.seq)t.type===e.SAMPLER_2D_SHADOW||t.type===e.SAMPLER_CUBE_SHADOW||t.type===e.SAMPLER_2D_ARRAY_SHADOW?r.push(t):i.push(t);r.length>0&&(this.seq=r.concat(i))}setValue(e,t,n,r){let i=this.map[t];i!==void 0&&i.setValue(e,n,r)}setOptional(e,t,n){let r=t[n];r!==void 0&&this.setValue(e,n,r)}static upload(e,t,n,r){for(let i=0,a=t.length;i!==a;++i){let a=t[i],o=n[a.id];o.needsUpdate!==!1&&a.setValue(e,o.value,r)}}static seqWithValue(e,t){let n=[];for(let r=0,i=e.length;r!==i;++r){let i=e[r];i.id in t&&n.push(i)}return n}};function wc(e,t,n){let r=e.createShader(t);return e.shaderSource(r,n),e.compileShader(r),r}var Tc=37297,Ec=0;function Dc(e,t){let n=e.split(`
`),r=[],i=Math.max(t-6,0),a=Math.min(t+6,n.length);for(let e=i;e<a;e++){let i=e+1;r.push(`${i===t?`>`:` `} ${i}: ${n[e]}`)}return r.join(`
`)}var Oc=new Y;function kc(e){jn._getMatrix(Oc,jn.workingColorSpace,e);let t=`mat3( ${Oc.elements.map(e=>e.toFixed(4))} )`;switch(jn.getTransfer(e)){case Mt:return[t,`LinearTransferOETF`];case Nt:return[t,`sRGBTransferOETF`];default:return G(`WebGLProgram: Unsupported color space: `,e),[t,`LinearTransferOETF`]}}function Ac(e,t,n){let r=e.getShaderParameter(t,e.COMPILE_STATUS),i=(e.getShaderInfoLog(t)||``).trim();if(r&&i===``)return``;let a=/ERROR: 0:(\d+)/.exec(i);if(a){let r=parseInt(a[1]);return n.toUpperCase()+`

`+i+`

`+Dc(e.getShaderSource(t),r)}return i}function jc(e,t){let n=kc(t);return[`vec4 ${e}( vec4 value ) {`,`	return ${n[1]}( vec4( ${n[0]} * value.rgb, value.a ) );`,`}`].join(`
`)}var Mc={1:`Linear`,2:`Reinhard`,3:`Cineon`,4:`ACESFilmic`,6:`AgX`,7:`Neutral`,5:`Custom`};function Nc(e,t){let n=Mc[t];return n===void 0?(G(`WebGLProgram: Unsupported toneMapping:`,t),`vec3 `+e+`( vec3 color ) { return LinearToneMapping( color ); }`):`vec3 `+e+`( vec3 color ) { return `+n+`ToneMapping( color ); }`}var Pc=new J;function Fc(){return jn.getLuminanceCoefficients(Pc),[`float luminance( const in vec3 rgb ) {`,`	const vec3 weights = vec3( ${Pc.x.toFixed(4)}, ${Pc.y.toFixed(4)}, ${Pc.z.toFixed(4)} );`,`	return dot( weights, rgb );`,`}`].join(`
`)}function Ic(e){return[e.extensionClipCullDistance?`#extension GL_ANGLE_clip_cull_distance : require`:``,e.extensionMultiDraw?`#extension GL_ANGLE_multi_draw : require`:``].filter(zc).join(`
`)}function Lc(e){let t=[];for(let n in e){let r=e[n];r!==!1&&t.push(`#define `+n+` `+r)}return t.join(`
`)}function Rc(e,t){let n={},r=e.getProgramParameter(t,e.ACTIVE_ATTRIBUTES);for(let i=0;i<r;i++){let r=e.getActiveAttrib(t,i),a=r.name,o=1;r.type===e.FLOAT_MAT2&&(o=2),r.type===e.FLOAT_MAT3&&(o=3),r.type===e.FLOAT_MAT4&&(o=4),n[a]={type:r.type,location:e.getAttribLocation(t,a),locationSize:o}}return n}function zc(e){return e!==``}function Bc(e,t){let n=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return e.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,n).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function Vc(e,t){return e.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var Hc=/^[ \t]*#include +<([\w\d./]+)>/gm;function Uc(e){return e.replace(Hc,Wc)}function Wc(e,t){let n=No[t];if(n===void 0)throw Error(`THREE.WebGLProgram: Can not resolve #include <`+t+`>`);return Uc(n)}var Gc=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Kc(e){return e.replace(Gc,qc)}function qc(e,t,n,r){let i=``;for(let e=parseInt(t);e<parseInt(n);e++)i+=r.replace(/\[\s*i\s*\]/g,`[ `+e+` ]`).replace(/UNROLLED_LOOP_INDEX/g,e);return i}function Jc(e){let t=`precision ${e.precision} float;
	precision ${e.precision} int;
	precision ${e.precision} sampler2D;
	precision ${e.precision} samplerCube;
	precision ${e.precision} sampler3D;
	precision ${e.precision} sampler2DArray;
	precision ${e.precision} sampler2DShadow;
	precision ${e.precision} samplerCubeShadow;
	precision ${e.precision} sampler2DArrayShadow;
	precision ${e.precision} isampler2D;
	precision ${e.precision} isampler3D;
	precision ${e.precision} isamplerCube;
	precision ${e.precision} isampler2DArray;
	precision ${e.precision} usampler2D;
	precision ${e.precision} usampler3D;
	precision ${e.precision} usamplerCube;
	precision ${e.precision} usampler2DArray;
	`;return e.precision===`highp`?t+=`
#define HIGH_PRECISION`:e.precision===`mediump`?t+=`
#define MEDIUM_PRECISION`:e.precision===`lowp`&&(t+=`
#define LOW_PRECISION`),t}var Yc={1:`SHADOWMAP_TYPE_PCF`,3:`SHADOWMAP_TYPE_VSM`};function Xc(e){return Yc[e.shadowMapType]||`SHADOWMAP_TYPE_BASIC`}var Zc={302:`ENVMAP_MODE_REFRACTION`};function Qc(e){return e.envMap===!1?`ENVMAP_MODE_REFLECTION`:Zc[e.envMapMode]||`ENVMAP_MODE_REFLECTION`}var $c={0:`ENVMAP_BLENDING_MULTIPLY`,1:`ENVMAP_BLENDING_MIX`,2:`ENVMAP_BLENDING_ADD`};function el(e){return e.envMap===!1?`ENVMAP_BLENDING_NONE`:$c[e.combine]||`ENVMAP_BLENDING_NONE`}function tl(e,t,n,r){let i=e.getContext(),a=n.defines,o=n.vertexShader,s=n.fragmentShader,c=Xc(n),l=n.envMapPMREM===!0?`ENVMAP_TYPE_PMREM`:`ENVMAP_TYPE_CUBE`,u=Qc(n),d=el(n),f=Ic(n),p=Lc(a),m=i.createProgram(),h,g,_=n.glslVersion?`#version `+n.glslVersion+`
`:``;n.isRawShaderMaterial?(h=[`#define SHADER_TYPE `+n.shaderType,`#define SHADER_NAME `+n.shaderName,p].filter(zc).join(`
`),h.length>0&&(h+=`
`),g=[`#define SHADER_TYPE `+n.shaderType,`#define SHADER_NAME `+n.shaderName,p].filter(zc).join(`
`),g.length>0&&(g+=`
`)):(h=[Jc(n),`#define SHADER_TYPE `+n.shaderType,`#define SHADER_NAME `+n.shaderName,p,n.extensionClipCullDistance?`#define USE_CLIP_DISTANCE`:``,n.batching?`#define USE_BATCHING`:``,n.batchingColor?`#define USE_BATCHING_COLOR`:``,n.instancing?`#define USE_INSTANCING`:``,n.instancingColor?`#define USE_INSTANCING_COLOR`:``,n.instancingMorph?`#define USE_INSTANCING_MORPH`:``,n.useFog&&n.fog?`#define USE_FOG`:``,n.useFog&&n.fogExp2?`#define FOG_EXP2`:``,n.map?`#define USE_MAP`:``,n.envMap?`#define USE_ENVMAP`:``,n.envMap?`#define `+u:``,n.lightMap?`#define USE_LIGHTMAP`:``,n.aoMap?`#define USE_AOMAP`:``,n.bumpMap?`#define USE_BUMPMAP`:``,n.normalMap?`#define USE_NORMALMAP`:``,n.normalMapObjectSpace?`#define USE_NORMALMAP_OBJECTSPACE`:``,n.normalMapTangentSpace?`#define USE_NORMALMAP_TANGENTSPACE`:``,n.displacementMap?`#define USE_DISPLACEMENTMAP`:``,n.emissiveMap?`#define USE_EMISSIVEMAP`:``,n.anisotropy?`#define USE_ANISOTROPY`:``,n.anisotropyMap?`#define USE_ANISOTROPYMAP`:``,n.clearcoatMap?`#define USE_CLEARCOATMAP`:``,n.clearcoatRoughnessMap?`#define USE_CLEARCOAT_ROUGHNESSMAP`:``,n.clearcoatNormalMap?`#define USE_CLEARCOAT_NORMALMAP`:``,n.diffuseRoughnessMap?`#define USE_DIFFUSE_ROUGHNESSMAP`:``,n.iridescenceMap?`#define USE_IRIDESCENCEMAP`:``,n.iridescenceThicknessMap?`#define USE_IRIDESCENCE_THICKNESSMAP`:``,n.specularMap?`#define USE_SPECULARMAP`:``,n.specularColorMap?`#define USE_SPECULAR_COLORMAP`:``,n.specularIntensityMap?`#define USE_SPECULAR_INTENSITYMAP`:``,n.roughnessMap?`#define USE_ROUGHNESSMAP`:``,n.metalnessMap?`#define USE_METALNESSMAP`:``,n.alphaMap?`#define USE_ALPHAMAP`:``,n.alphaHash?`#define USE_ALPHAHASH`:``,n.transmission?`#define USE_TRANSMISSION`:``,n.transmissionMap?`#define USE_TRANSMISSIONMAP`:``,n.thicknessMap?`#define USE_THICKNESSMAP`:``,n.sheenColorMap?`#define USE_SHEEN_COLORMAP`:``,n.sheenRoughnessMap?`#define USE_SHEEN_ROUGHNESSMAP`:``,n.mapUv?`#define MAP_UV `+n.mapUv:``,n.alphaMapUv?`#define ALPHAMAP_UV `+n.alphaMapUv:``,n.lightMapUv?`#define LIGHTMAP_UV `+n.lightMapUv:``,n.aoMapUv?`#define AOMAP_UV `+n.aoMapUv:``,n.emissiveMapUv?`#define EMISSIVEMAP_UV `+n.emissiveMapUv:``,n.bumpMapUv?`#define BUMPMAP_UV `+n.bumpMapUv:``,n.normalMapUv?`#define NORMALMAP_UV `+n.normalMapUv:``,n.displacementMapUv?`#define DISPLACEMENTMAP_UV `+n.displacementMapUv:``,n.metalnessMapUv?`#define METALNESSMAP_UV `+n.metalnessMapUv:``,n.roughnessMapUv?`#define ROUGHNESSMAP_UV `+n.roughnessMapUv:``,n.anisotropyMapUv?`#define ANISOTROPYMAP_UV `+n.anisotropyMapUv:``,n.clearcoatMapUv?`#define CLEARCOATMAP_UV `+n.clearcoatMapUv:``,n.clearcoatNormalMapUv?`#define CLEARCOAT_NORMALMAP_UV `+n.clearcoatNormalMapUv:``,n.clearcoatRoughnessMapUv?`#define CLEARCOAT_ROUGHNESSMAP_UV `+n.clearcoatRoughnessMapUv:``,n.diffuseRoughnessMapUv?`#define DIFFUSE_ROUGHNESSMAP_UV `+n.diffuseRoughnessMapUv:``,n.iridescenceMapUv?`#define IRIDESCENCEMAP_UV `+n.iridescenceMapUv:``,n.iridescenceThicknessMapUv?`#define IRIDESCENCE_THICKNESSMAP_UV `+n.iridescenceThicknessMapUv:``,n.sheenColorMapUv?`#define SHEEN_COLORMAP_UV `+n.sheenColorMapUv:``,n.sheenRoughnessMapUv?`#define SHEEN_ROUGHNESSMAP_UV `+n.sheenRoughnessMapUv:``,n.specularMapUv?`#define SPECULARMAP_UV `+n.specularMapUv:``,n.specularColorMapUv?`#define SPECULAR_COLORMAP_UV `+n.specularColorMapUv:``,n.specularIntensityMapUv?`#define SPECULAR_INTENSITYMAP_UV `+n.specularIntensityMapUv:``,n.transmissionMapUv?`#define TRANSMISSIONMAP_UV `+n.transmissionMapUv:``,n.thicknessMapUv?`#define THICKNESSMAP_UV `+n.thicknessMapUv:``,n.vertexTangents&&n.flatShading===!1?`#define USE_TANGENT`:``,n.vertexNormals?`#define HAS_NORMAL`:``,n.vertexColors?`#define USE_COLOR`:``,n.vertexAlphas?`#define USE_COLOR_ALPHA`:``,n.vertexUv1s?`#define USE_UV1`:``,n.vertexUv2s?`#define USE_UV2`:``,n.vertexUv3s?`#define USE_UV3`:``,n.pointsUvs?`#define USE_POINTS_UV`:``,n.flatShading?`#define FLAT_SHADED`:``,n.skinning?`#define USE_SKINNING`:``,n.morphTargets?`#define USE_MORPHTARGETS`:``,n.morphNormals&&n.flatShading===!1?`#define USE_MORPHNORMALS`:``,n.morphColors?`#define USE_MORPHCOLORS`:``,n.morphTargetsCount>0?`#define MORPHTARGETS_TEXTURE_STRIDE `+n.morphTextureStride:``,n.morphTargetsCount>0?`#define MORPHTARGETS_COUNT `+n.morphTargetsCount:``,n.doubleSided?`#define DOUBLE_SIDED`:``,n.flipSided?`#define FLIP_SIDED`:``,n.shadowMapEnabled?`#define USE_SHADOWMAP`:``,n.shadowMapEnabled?`#define `+c:``,n.sizeAttenuation?`#define USE_SIZEATTENUATION`:``,n.numLightProbes>0?`#define USE_LIGHT_PROBES`:``,n.logarithmicDepthBuffer?`#define USE_LOGARITHMIC_DEPTH_BUFFER`:``,n.reversedDepthBuffer?`#define USE_REVERSED_DEPTH_BUFFER`:``,`uniform mat4 modelMatrix;`,`uniform mat4 modelViewMatrix;`,`uniform mat4 projectionMatrix;`,`uniform mat4 viewMatrix;`,`uniform mat3 normalMatrix;`,`uniform vec3 cameraPosition;`,`uniform bool isOrthographic;`,`#ifdef USE_INSTANCING`,`	attribute mat4 instanceMatrix;`,`#endif`,`#ifdef USE_INSTANCING_COLOR`,`	attribute vec3 instanceColor;`,`#endif`,`#ifdef USE_INSTANCING_MORPH`,`	uniform sampler2D morphTexture;`,`#endif`,`attribute vec3 position;`,`attribute vec3 normal;`,`attribute vec2 uv;`,`#ifdef USE_UV1`,`	attribute vec2 uv1;`,`#endif`,`#ifdef USE_UV2`,`	attribute vec2 uv2;`,`#endif`,`#ifdef USE_UV3`,`	attribute vec2 uv3;`,`#endif`,`#ifdef USE_TANGENT`,`	attribute vec4 tangent;`,`#endif`,`#if defined( USE_COLOR_ALPHA )`,`	attribute vec4 color;`,`#elif defined( USE_COLOR )`,`	attribute vec3 color;`,`#endif`,`#ifdef USE_SKINNING`,`	attribute vec4 skinIndex;`,`	attribute vec4 skinWeight;`,`#endif`,`
`].filter(zc).join(`
`),g=[Jc(n),`#define SHADER_TYPE `+n.shaderType,`#define SHADER_NAME `+n.shaderName,p,n.useFog&&n.fog?`#define USE_FOG`:``,n.useFog&&n.fogExp2?`#define FOG_EXP2`:``,n.alphaToCoverage?`#define ALPHA_TO_COVERAGE`:``,n.map?`#define USE_MAP`:``,n.matcap?`#define USE_MATCAP`:``,n.envMap?`#define USE_ENVMAP`:``,n.envMap?`#define `+l:``,n.envMap?`#define `+u:``,n.envMap?`#define `+d:``,n.envMapPMREM?`#define ENVMAP_MAX_LOD `+n.envMapMaxLod+`.0`:``,n.envMapPMREM?`#define ENVMAP_SIZE `+n.envMapSize+`.0`:``,n.lightMap?`#define USE_LIGHTMAP`:``,n.aoMap?`#define USE_AOMAP`:``,n.bumpMap?`#define USE_BUMPMAP`:``,n.normalMap?`#define USE_NORMALMAP`:``,n.normalMapObjectSpace?`#define USE_NORMALMAP_OBJECTSPACE`:``,n.normalMapTangentSpace?`#define USE_NORMALMAP_TANGENTSPACE`:``,n.packedNormalMap?`#define USE_PACKED_NORMALMAP`:``,n.emissiveMap?`#define USE_EMISSIVEMAP`:``,n.anisotropy?`#define USE_ANISOTROPY`:``,n.anisotropyMap?`#define USE_ANISOTROPYMAP`:``,n.clearcoat?`#define USE_CLEARCOAT`:``,n.clearcoatMap?`#define USE_CLEARCOATMAP`:``,n.clearcoatRoughnessMap?`#define USE_CLEARCOAT_ROUGHNESSMAP`:``,n.clearcoatNormalMap?`#define USE_CLEARCOAT_NORMALMAP`:``,n.diffuseRoughness?`#define USE_DIFFUSE_ROUGHNESS`:``,n.diffuseRoughnessMap?`#define USE_DIFFUSE_ROUGHNESSMAP`:``,n.dispersion?`#define USE_DISPERSION`:``,n.retroreflection?`#define USE_RETROREFLECTION`:``,n.iridescence?`#define USE_IRIDESCENCE`:``,n.iridescenceMap?`#define USE_IRIDESCENCEMAP`:``,n.iridescenceThicknessMap?`#define USE_IRIDESCENCE_THICKNESSMAP`:``,n.specularMap?`#define USE_SPECULARMAP`:``,n.specularColorMap?`#define USE_SPECULAR_COLORMAP`:``,n.specularIntensityMap?`#define USE_SPECULAR_INTENSITYMAP`:``,n.roughnessMap?`#define USE_ROUGHNESSMAP`:``,n.metalnessMap?`#define USE_METALNESSMAP`:``,n.alphaMap?`#define USE_ALPHAMAP`:``,n.alphaTest?`#define USE_ALPHATEST`:``,n.alphaHash?`#define USE_ALPHAHASH`:``,n.sheen?`#define USE_SHEEN`:``,n.sheenColorMap?`#define USE_SHEEN_COLORMAP`:``,n.sheenRoughnessMap?`#define USE_SHEEN_ROUGHNESSMAP`:``,n.transmission?`#define USE_TRANSMISSION`:``,n.transmissionMap?`#define USE_TRANSMISSIONMAP`:``,n.thicknessMap?`#define USE_THICKNESSMAP`:``,n.vertexTangents&&n.flatShading===!1?`#define USE_TANGENT`:``,n.vertexColors||n.instancingColor?`#define USE_COLOR`:``,n.vertexAlphas||n.batchingColor?`#define USE_COLOR_ALPHA`:``,n.vertexUv1s?`#define USE_UV1`:``,n.vertexUv2s?`#define USE_UV2`:``,n.vertexUv3s?`#define USE_UV3`:``,n.pointsUvs?`#define USE_POINTS_UV`:``,n.gradientMap?`#define USE_GRADIENTMAP`:``,n.flatShading?`#define FLAT_SHADED`:``,n.doubleSided?`#define DOUBLE_SIDED`:``,n.flipSided?`#define FLIP_SIDED`:``,n.shadowMapEnabled?`#define USE_SHADOWMAP`:``,n.shadowMapEnabled?`#define `+c:``,n.premultipliedAlpha?`#define PREMULTIPLIED_ALPHA`:``,n.numLightProbes>0?`#define USE_LIGHT_PROBES`:``,n.decodeVideoTexture?`#define DECODE_VIDEO_TEXTURE`:``,n.decodeVideoTextureEmissive?`#define DECODE_VIDEO_TEXTURE_EMISSIVE`:``,n.logarithmicDepthBuffer?`#define USE_LOGARITHMIC_DEPTH_BUFFER`:``,n.reversedDepthBuffer?`#define USE_REVERSED_DEPTH_BUFFER`:``,`uniform mat4 viewMatrix;`,`uniform vec3 cameraPosition;`,`uniform bool isOrthographic;`,n.toneMapping===0?``:`#define TONE_MAPPING`,n.toneMapping===0?``:No.tonemapping_pars_fragment,n.toneMapping===0?``:Nc(`toneMapping`,n.toneMapping),n.dithering?`#define DITHERING`:``,n.opaque?`#define OPAQUE`:``,No.colorspace_pars_fragment,jc(`linearToOutputTexel`,n.outputColorSpace),Fc(),n.useDepthPacking?`#define DEPTH_PACKING `+n.depthPacking:``,`
`].filter(zc).join(`
`)),o=Uc(o),o=Bc(o,n),o=Vc(o,n),s=Uc(s),s=Bc(s,n),s=Vc(s,n),o=Kc(o),s=Kc(s),n.isRawShaderMaterial!==!0&&(_=`#version 300 es
`,h=[f,`#define attribute in`,`#define varying out`,`#define texture2D texture`].join(`
`)+`
`+h,g=[`#define varying in`,n.glslVersion===`300 es`?``:`layout(location = 0) out highp vec4 pc_fragColor;`,n.glslVersion===`300 es`?``:`#define gl_FragColor pc_fragColor`,`#define gl_FragDepthEXT gl_FragDepth`,`#define texture2D texture`,`#define textureCube texture`,`#define texture2DProj textureProj`,`#define texture2DLodEXT textureLod`,`#define texture2DProjLodEXT textureProjLod`,`#define textureCubeLodEXT textureLod`,`#define texture2DGradEXT textureGrad`,`#define texture2DProjGradEXT textureProjGrad`,`#define textureCubeGradEXT textureGrad`].join(`
`)+`
`+g);let v=_+h+o,y=_+g+s,b=wc(i,i.VERTEX_SHADER,v),x=wc(i,i.FRAGMENT_SHADER,y);i.attachShader(m,b),i.attachShader(m,x),n.index0AttributeName===void 0?n.hasPositionAttribute===!0&&i.bindAttribLocation(m,0,`position`):i.bindAttribLocation(m,0,n.index0AttributeName),i.linkProgram(m);function S(t){if(e.debug.checkShaderErrors){let n=i.getProgramInfoLog(m)||``,r=i.getShaderInfoLog(b)||``,a=i.getShaderInfoLog(x)||``,o=n.trim(),s=r.trim(),c=a.trim(),l=!0,u=!0;if(i.getProgramParameter(m,i.LINK_STATUS)===!1){if(l=!1,typeof e.debug.onShaderError==`function`)e.debug.onShaderError(i,m,b,x);else{let e=Ac(i,b,`vertex`),n=Ac(i,x,`fragment`);K(`WebGLProgram: Shader Error `+i.getError()+` - VALIDATE_STATUS `+i.getProgramParameter(m,i.VALIDATE_STATUS)+`

Material Name: `+t.name+`
Material Type: `+t.type+`

Program Info Log: `+o+`
`+e+`
`+n)}}else o===``?(s===``||c===``)&&(u=!1):G(`WebGLProgram: Program Info Log:`,o);u&&(t.diagnostics={runnable:l,programLog:o,vertexShader:{log:s,prefix:h},fragmentShader:{log:c,prefix:g}})}i.deleteShader(b),i.deleteShader(x),C=new Cc(i,m),w=Rc(i,m)}let C;this.getUniforms=function(){return C===void 0&&S(this),C};let w;this.getAttributes=function(){return w===void 0&&S(this),w};let T=n.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return T===!1&&(T=i.getProgramParameter(m,Tc)),T},this.destroy=function(){r.releaseStatesOfProgram(this),i.deleteProgram(m),this.program=void 0},this.type=n.shaderType,this.name=n.shaderName,this.id=Ec++,this.cacheKey=t,this.usedTimes=1,this.program=m,this.vertexShader=b,this.fragmentShader=x,this}var nl=0,rl=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let r=this._getShaderCacheForMaterial(e);return r.has(t)===!1&&(r.add(t),t.usedTimes++),r.has(n)===!1&&(r.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let e of t)e.usedTimes--,e.usedTimes===0&&this.shaderCache.delete(e.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new il(e),t.set(e,n)),n}},il=class{constructor(e){this.id=nl++,this.code=e,this.usedTimes=0}};function al(e){return e===1030||e===37490||e===36285}function ol(e,t,n,r,i,a){let o=new ir,s=new rl,c=new Set,l=[],u=new Map,d=r.logarithmicDepthBuffer,f={MeshDepthMaterial:`depth`,MeshDistanceMaterial:`distance`,MeshNormalMaterial:`normal`,MeshBasicMaterial:`basic`,MeshLambertMaterial:`lambert`,MeshPhongMaterial:`phong`,MeshToonMaterial:`toon`,MeshStandardMaterial:`physical`,MeshPhysicalMaterial:`physical`,MeshMatcapMaterial:`matcap`,LineBasicMaterial:`basic`,LineDashedMaterial:`dashed`,PointsMaterial:`points`,ShadowMaterial:`shadow`,SpriteMaterial:`sprite`};function p(e){return c.add(e),e===0?`uv`:`uv${e}`}function m(i,o,l,u,m,h){let g=u.fog,_=m.geometry,v=i.isMeshStandardMaterial||i.isMeshLambertMaterial||i.isMeshPhongMaterial?u.environment:null,y=i.isMeshStandardMaterial||i.isMeshLambertMaterial&&!i.envMap||i.isMeshPhongMaterial&&!i.envMap,b=t.get(i.envMap||v,y),x=f[i.type],S=r.precision;i.precision!==null&&(S=r.getMaxPrecision(i.precision),S!==i.precision&&G(`WebGLProgram.getParameters:`,i.precision,`not supported, using`,S,`instead.`));let C=_.morphAttributes.position||_.morphAttributes.normal||_.morphAttributes.color,w=C===void 0?0:C.length,T=0;_.morphAttributes.position!==void 0&&(T=1),_.morphAttributes.normal!==void 0&&(T=2),_.morphAttributes.color!==void 0&&(T=3);let E,D,O,k;if(x){let e=Po[x];E=e.vertexShader,D=e.fragmentShader}else{E=i.vertexShader,D=i.fragmentShader;let e=s.getVertexShaderStage(i),t=s.getFragmentShaderStage(i);s.update(i,e,t),O=e.id,k=t.id}let A=e.getRenderTarget(),j=e.state.buffers.depth.getReversed(),M=m.isInstancedMesh===!0,N=m.isBatchedMesh===!0,ee=!!i.map,te=!!i.matcap,ne=!!b,re=ne&&b.isPMREMTexture===!0,ie=!!i.aoMap,P=!!i.lightMap,ae=!!i.bumpMap&&i.wireframe===!1,F=!!i.normalMap,I=!!i.displacementMap,L=!!i.emissiveMap,oe=!!i.metalnessMap,se=!!i.roughnessMap,ce=i.anisotropy>0,le=i.clearcoat>0,ue=i.diffuseRoughness>0,de=i.dispersion>0,fe=i.retroreflectivity>0,pe=i.iridescence>0,me=i.sheen>0,he=i.transmission>0,ge=ce&&!!i.anisotropyMap,_e=le&&!!i.clearcoatMap,ve=le&&!!i.clearcoatNormalMap,ye=le&&!!i.clearcoatRoughnessMap,be=ue&&!!i.diffuseRoughnessMap,R=pe&&!!i.iridescenceMap,z=pe&&!!i.iridescenceThicknessMap,B=me&&!!i.sheenColorMap,xe=me&&!!i.sheenRoughnessMap,V=!!i.specularMap,Se=!!i.specularColorMap,Ce=!!i.specularIntensityMap,H=he&&!!i.transmissionMap,we=he&&!!i.thicknessMap,Te=!!i.gradientMap,Ee=!!i.alphaMap,De=i.alphaTest>0,Oe=!!i.alphaHash,ke=!!i.extensions,U=0;i.toneMapped&&(A===null||A.isXRRenderTarget===!0)&&(U=e.toneMapping);let W=re?b.isCompressedCubeTexture?b.image[0].mipmaps:b.mipmaps:null,Ae={shaderID:x,shaderType:i.type,shaderName:i.name,vertexShader:E,fragmentShader:D,defines:i.defines,customVertexShaderID:O,customFragmentShaderID:k,isRawShaderMaterial:i.isRawShaderMaterial===!0,glslVersion:i.glslVersion,precision:S,batching:N,batchingColor:N&&m._colorsTexture!==null,instancing:M,instancingColor:M&&m.instanceColor!==null,instancingMorph:M&&m.morphTexture!==null,outputColorSpace:A===null?e.outputColorSpace:A.isXRRenderTarget===!0?A.texture.colorSpace:jn.workingColorSpace,alphaToCoverage:!!i.alphaToCoverage,map:ee,matcap:te,envMap:ne,envMapMode:ne&&b.mapping,envMapPMREM:re,envMapMaxLod:re?W.length-1:null,envMapSize:re?W[0].width:null,aoMap:ie,lightMap:P,bumpMap:ae,normalMap:F,displacementMap:I,emissiveMap:L,normalMapObjectSpace:F&&i.normalMapType===1,normalMapTangentSpace:F&&i.normalMapType===0,packedNormalMap:F&&i.normalMapType===0&&al(i.normalMap.format),metalnessMap:oe,roughnessMap:se,anisotropy:ce,anisotropyMap:ge,clearcoat:le,clearcoatMap:_e,clearcoatNormalMap:ve,clearcoatRoughnessMap:ye,diffuseRoughness:ue,diffuseRoughnessMap:be,dispersion:de,retroreflection:fe,iridescence:pe,iridescenceMap:R,iridescenceThicknessMap:z,sheen:me,sheenColorMap:B,sheenRoughnessMap:xe,specularMap:V,specularColorMap:Se,specularIntensityMap:Ce,transmission:he,transmissionMap:H,thicknessMap:we,gradientMap:Te,opaque:i.transparent===!1&&i.blending===1&&i.alphaToCoverage===!1,alphaMap:Ee,alphaTest:De,alphaHash:Oe,combine:i.combine,mapUv:ee&&p(i.map.channel),aoMapUv:ie&&p(i.aoMap.channel),lightMapUv:P&&p(i.lightMap.channel),bumpMapUv:ae&&p(i.bumpMap.channel),normalMapUv:F&&p(i.normalMap.channel),displacementMapUv:I&&p(i.displacementMap.channel),emissiveMapUv:L&&p(i.emissiveMap.channel),metalnessMapUv:oe&&p(i.metalnessMap.channel),roughnessMapUv:se&&p(i.roughnessMap.channel),anisotropyMapUv:ge&&p(i.anisotropyMap.channel),clearcoatMapUv:_e&&p(i.clearcoatMap.channel),clearcoatNormalMapUv:ve&&p(i.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:ye&&p(i.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:be&&p(i.diffuseRoughnessMap.channel),iridescenceMapUv:R&&p(i.iridescenceMap.channel),iridescenceThicknessMapUv:z&&p(i.iridescenceThicknessMap.channel),sheenColorMapUv:B&&p(i.sheenColorMap.channel),sheenRoughnessMapUv:xe&&p(i.sheenRoughnessMap.channel),specularMapUv:V&&p(i.specularMap.channel),specularColorMapUv:Se&&p(i.specularColorMap.channel),specularIntensityMapUv:Ce&&p(i.specularIntensityMap.channel),transmissionMapUv:H&&p(i.transmissionMap.channel),thicknessMapUv:we&&p(i.thicknessMap.channel),alphaMapUv:Ee&&p(i.alphaMap.channel),vertexTangents:!!_.attributes.tangent&&(F||ce),vertexNormals:!!_.attributes.normal,vertexColors:i.vertexColors,vertexAlphas:i.vertexColors===!0&&!!_.attributes.color&&_.attributes.color.itemSize===4,pointsUvs:m.isPoints===!0&&!!_.attributes.uv&&(ee||Ee),fog:!!g,useFog:i.fog===!0,fogExp2:!!g&&g.isFogExp2,flatShading:i.wireframe===!1&&(i.flatShading===!0||_.attributes.normal===void 0&&F===!1&&(i.isMeshLambertMaterial||i.isMeshPhongMaterial||i.isMeshStandardMaterial||i.isMeshPhysicalMaterial)),sizeAttenuation:i.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:j,skinning:m.isSkinnedMesh===!0,hasPositionAttribute:_.attributes.position!==void 0,morphTargets:_.morphAttributes.position!==void 0,morphNormals:_.morphAttributes.normal!==void 0,morphColors:_.morphAttributes.color!==void 0,morphTargetsCount:w,morphTextureStride:T,numSunLights:o.sun.length,numDirLights:o.directional.length,numPointLights:o.point.length,numSpotLights:o.spot.length,numSpotLightMaps:o.spotLightMap.length,numRectAreaLights:o.rectArea.length,numHemiLights:o.hemi.length,numSunLightShadows:o.sunShadowMap.length,numDirLightShadows:o.directionalShadowMap.length,numPointLightShadows:o.pointShadowMap.length,numSpotLightShadows:o.spotShadowMap.length,numSpotLightShadowsWithMaps:o.numSpotLightShadowsWithMaps,numLightProbes:o.numLightProbes,numLightProbeGrids:h.filter(e=>e.texture!==null).length,numClippingPlanes:a.numPlanes,numClipIntersection:a.numIntersection,dithering:i.dithering,shadowMapEnabled:e.shadowMap.enabled&&l.length>0,shadowMapType:e.shadowMap.type,toneMapping:U,decodeVideoTexture:ee&&i.map.isVideoTexture===!0&&jn.getTransfer(i.map.colorSpace)===`srgb`,decodeVideoTextureEmissive:L&&i.emissiveMap.isVideoTexture===!0&&jn.getTransfer(i.emissiveMap.colorSpace)===`srgb`,premultipliedAlpha:i.premultipliedAlpha,doubleSided:i.side===2,flipSided:i.side===1,useDepthPacking:i.depthPacking>=0,depthPacking:i.depthPacking||0,index0AttributeName:i.index0AttributeName,extensionClipCullDistance:ke&&i.extensions.clipCullDistance===!0&&n.has(`WEBGL_clip_cull_distance`),extensionMultiDraw:(ke&&i.extensions.multiDraw===!0||N)&&n.has(`WEBGL_multi_draw`),rendererExtensionParallelShaderCompile:n.has(`KHR_parallel_shader_compile`),customProgramCacheKey:i.customProgramCacheKey()};return Ae.vertexUv1s=c.has(1),Ae.vertexUv2s=c.has(2),Ae.vertexUv3s=c.has(3),c.clear(),Ae}function h(t){let n=[];if(t.shaderID?n.push(t.shaderID):(n.push(t.customVertexShaderID),n.push(t.customFragmentShaderID)),t.defines!==void 0)for(let e in t.defines)n.push(e),n.push(t.defines[e]);return t.isRawShaderMaterial===!1&&(g(n,t),_(n,t),n.push(e.outputColorSpace)),n.push(t.customProgramCacheKey),n.join()}function g(e,t){e.push(t.precision),e.push(t.outputColorSpace),e.push(t.envMapMode),e.push(t.envMapPMREM),e.push(t.envMapMaxLod),e.push(t.envMapSize),e.push(t.mapUv),e.push(t.alphaMapUv),e.push(t.lightMapUv),e.push(t.aoMapUv),e.push(t.bumpMapUv),e.push(t.normalMapUv),e.push(t.displacementMapUv),e.push(t.emissiveMapUv),e.push(t.metalnessMapUv),e.push(t.roughnessMapUv),e.push(t.anisotropyMapUv),e.push(t.clearcoatMapUv),e.push(t.clearcoatNormalMapUv),e.push(t.clearcoatRoughnessMapUv),e.push(t.diffuseRoughnessMapUv),e.push(t.iridescenceMapUv),e.push(t.iridescenceThicknessMapUv),e.push(t.sheenColorMapUv),e.push(t.sheenRoughnessMapUv),e.push(t.specularMapUv),e.push(t.specularColorMapUv),e.push(t.specularIntensityMapUv),e.push(t.transmissionMapUv),e.push(t.thicknessMapUv),e.push(t.combine),e.push(t.fogExp2),e.push(t.sizeAttenuation),e.push(t.morphTargetsCount),e.push(t.numSunLights),e.push(t.numDirLights),e.push(t.numPointLights),e.push(t.numSpotLights),e.push(t.numSpotLightMaps),e.push(t.numHemiLights),e.push(t.numRectAreaLights),e.push(t.numSunLightShadows),e.push(t.numDirLightShadows),e.push(t.numPointLightShadows),e.push(t.numSpotLightShadows),e.push(t.numSpotLightShadowsWithMaps),e.push(t.numLightProbes),e.push(t.numLightProbeGrids),e.push(t.shadowMapType),e.push(t.toneMapping),e.push(t.numClippingPlanes),e.push(t.numClipIntersection),e.push(t.depthPacking)}function _(e,t){o.disableAll(),t.instancing&&o.enable(0),t.instancingColor&&o.enable(1),t.instancingMorph&&o.enable(2),t.matcap&&o.enable(3),t.envMap&&o.enable(4),t.normalMapObjectSpace&&o.enable(5),t.normalMapTangentSpace&&o.enable(6),t.clearcoat&&o.enable(7),t.iridescence&&o.enable(8),t.alphaTest&&o.enable(9),t.vertexColors&&o.enable(10),t.vertexAlphas&&o.enable(11),t.vertexUv1s&&o.enable(12),t.vertexUv2s&&o.enable(13),t.vertexUv3s&&o.enable(14),t.vertexTangents&&o.enable(15),t.anisotropy&&o.enable(16),t.alphaHash&&o.enable(17),t.batching&&o.enable(18),t.dispersion&&o.enable(19),t.retroreflection&&o.enable(24),t.diffuseRoughness&&o.enable(25),t.batchingColor&&o.enable(20),t.gradientMap&&o.enable(21),t.packedNormalMap&&o.enable(22),t.vertexNormals&&o.enable(23),e.push(o.mask),o.disableAll(),t.fog&&o.enable(0),t.useFog&&o.enable(1),t.flatShading&&o.enable(2),t.logarithmicDepthBuffer&&o.enable(3),t.reversedDepthBuffer&&o.enable(4),t.skinning&&o.enable(5),t.morphTargets&&o.enable(6),t.morphNormals&&o.enable(7),t.morphColors&&o.enable(8),t.premultipliedAlpha&&o.enable(9),t.shadowMapEnabled&&o.enable(10),t.doubleSided&&o.enable(11),t.flipSided&&o.enable(12),t.useDepthPacking&&o.enable(13),t.dithering&&o.enable(14),t.transmission&&o.enable(15),t.sheen&&o.enable(16),t.opaque&&o.enable(17),t.pointsUvs&&o.enable(18),t.decodeVideoTexture&&o.enable(19),t.decodeVideoTextureEmissive&&o.enable(20),t.alphaToCoverage&&o.enable(21),t.numLightProbeGrids>0&&o.enable(22),t.hasPositionAttribute&&o.enable(23),e.push(o.mask)}function v(e){let t=f[e.type],n;if(t){let e=Po[t];n=Oa.clone(e.uniforms)}else n=e.uniforms;return n}function y(t,n){let r=u.get(n);return r===void 0?(r=new tl(e,n,t,i),l.push(r),u.set(n,r)):++r.usedTimes,r}function b(e){if(--e.usedTimes===0){let t=l.indexOf(e);l[t]=l[l.length-1],l.pop(),u.delete(e.cacheKey),e.destroy()}}function x(e){s.remove(e)}function S(){s.dispose()}return{getParameters:m,getProgramCacheKey:h,getUniforms:v,acquireProgram:y,releaseProgram:b,releaseShaderCache:x,programs:l,dispose:S}}function sl(){let e=new WeakMap;function t(t){return e.has(t)}function n(t){let n=e.get(t);return n===void 0&&(n={},e.set(t,n)),n}function r(t){e.delete(t)}function i(t,n,r){e.get(t)[n]=r}function a(){e=new WeakMap}return{has:t,get:n,remove:r,update:i,dispose:a}}function cl(e,t){return e.groupOrder===t.groupOrder?e.renderOrder===t.renderOrder?e.material.id===t.material.id?e.materialVariant===t.materialVariant?e.z===t.z?e.id-t.id:e.z-t.z:e.materialVariant-t.materialVariant:e.material.id-t.material.id:e.renderOrder-t.renderOrder:e.groupOrder-t.groupOrder}function ll(e,t){return e.groupOrder===t.groupOrder?e.renderOrder===t.renderOrder?e.z===t.z?e.id-t.id:t.z-e.z:e.renderOrder-t.renderOrder:e.groupOrder-t.groupOrder}function ul(){let e=[],t=0,n=[],r=[],i=[];function a(){t=0,n.length=0,r.length=0,i.length=0}function o(e){let t=0;return e.isInstancedMesh&&(t+=2),e.isSkinnedMesh&&(t+=1),t}function s(n,r,i,a,s,c){let l=e[t];return l===void 0?(l={id:n.id,object:n,geometry:r,material:i,materialVariant:o(n),groupOrder:a,renderOrder:n.renderOrder,z:s,group:c},e[t]=l):(l.id=n.id,l.object=n,l.geometry=r,l.material=i,l.materialVariant=o(n),l.groupOrder=a,l.renderOrder=n.renderOrder,l.z=s,l.group=c),t++,l}function c(e,t,a,o,c,l,u){u.reversedDepth===!0&&(c=-c);let d=s(e,t,a,o,c,l);a.transmission>0?r.push(d):a.transparent===!0?i.push(d):n.push(d)}function l(e,t,a,o,c,l){let u=s(e,t,a,o,c,l);a.transmission>0?r.unshift(u):a.transparent===!0?i.unshift(u):n.unshift(u)}function u(e,t){n.length>1&&n.sort(e||cl),r.length>1&&r.sort(t||ll),i.length>1&&i.sort(t||ll)}function d(){for(let n=t,r=e.length;n<r;n++){let t=e[n];if(t.id===null)break;t.id=null,t.object=null,t.geometry=null,t.material=null,t.group=null}}return{opaque:n,transmissive:r,transparent:i,init:a,push:c,unshift:l,finish:d,sort:u}}function dl(){let e=new WeakMap;function t(t,n){let r=e.get(t),i;return r===void 0?(i=new ul,e.set(t,[i])):n>=r.length?(i=new ul,r.push(i)):i=r[n],i}function n(){e=new WeakMap}return{get:t,dispose:n}}function fl(){let e={};return{get:function(t){if(e[t.id]!==void 0)return e[t.id];let n;switch(t.type){case`SunLight`:case`DirectionalLight`:n={direction:new J,color:new Or};break;case`SpotLight`:n={position:new J,direction:new J,color:new Or,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case`PointLight`:n={position:new J,color:new Or,distance:0,decay:0};break;case`HemisphereLight`:n={direction:new J,skyColor:new Or,groundColor:new Or};break;case`RectAreaLight`:n={color:new Or,position:new J,halfWidth:new J,halfHeight:new J}}return e[t.id]=n,n}}}function pl(){let e={};return{get:function(t){if(e[t.id]!==void 0)return e[t.id];let n;switch(t.type){case`SunLight`:case`DirectionalLight`:n={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new q};break;case`SpotLight`:n={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new q};break;case`PointLight`:n={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new q,shadowCameraNear:1,shadowCameraFar:1e3}}return e[t.id]=n,n}}}var ml=0;function hl(e,t){return(t.castShadow?2:0)-(e.castShadow?2:0)+ +!!t.map-!!e.map}function gl(e){let t=new fl,n=pl(),r={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let e=0;e<9;e++)r.probe.push(new J);let i=new J,a=new qn,o=new qn;function s(i){let a=0,o=0,s=0;for(let e=0;e<9;e++)r.probe[e].set(0,0,0);let c=0,l=0,u=0,d=0,f=0,p=0,m=0,h=0,g=0,_=0,v=0,y=0,b=0,x=0;i.sort(hl);for(let e=0,S=i.length;e<S;e++){let S=i[e],C=S.color,w=S.intensity,T=S.distance,E=null;if(S.shadow&&S.shadow.map&&(E=S.shadow.map.texture.format===1030?S.shadow.map.texture:S.shadow.map.depthTexture||S.shadow.map.texture),S.isAmbientLight)a+=C.r*w,o+=C.g*w,s+=C.b*w;else if(S.isLightProbe){for(let e=0;e<9;e++)r.probe[e].addScaledVector(S.sh.coefficients[e],w);x++}else if(S.isSunLight){let e=t.get(S);if(e.color.copy(S.color).multiplyScalar(S.intensity),S.castShadow){let e=S.shadow,t=n.get(S);t.shadowIntensity=e.intensity,t.shadowBias=e.bias,t.shadowNormalBias=e.normalBias,t.shadowRadius=e.radius,t.shadowMapSize.copy(e.mapSize).multiply(e.getFrameExtents()),r.sunShadow[l]=t,r.sunShadowMap[l]=E;let i=e.getViewportCount();for(let t=0;t<i;t++)r.sunShadowMatrix[u+t]=e.getMatrix(t),r.sunShadowCascade[u+t]=e._cascadeData[t];u+=i,l++}r.sun[c]=e,c++}else if(S.isDirectionalLight){let e=t.get(S);if(e.color.copy(S.color).multiplyScalar(S.intensity),S.castShadow){let e=S.shadow,t=n.get(S);t.shadowIntensity=e.intensity,t.shadowBias=e.bias,t.shadowNormalBias=e.normalBias,t.shadowRadius=e.radius,t.shadowMapSize=e.mapSize,r.directionalShadow[d]=t,r.directionalShadowMap[d]=E,r.directionalShadowMatrix[d]=S.shadow.matrix,g++}r.directional[d]=e,d++}else if(S.isSpotLight){let e=t.get(S);e.position.setFromMatrixPosition(S.matrixWorld),e.color.copy(C).multiplyScalar(w),e.distance=T,e.coneCos=Math.cos(S.angle),e.penumbraCos=Math.cos(S.angle*(1-S.penumbra)),e.decay=S.decay,r.spot[p]=e;let i=S.shadow;if(S.map&&(r.spotLightMap[y]=S.map,y++,i.updateMatrices(S),S.castShadow&&b++),r.spotLightMatrix[p]=i.matrix,S.castShadow){let e=n.get(S);e.shadowIntensity=i.intensity,e.shadowBias=i.bias,e.shadowNormalBias=i.normalBias,e.shadowRadius=i.radius,e.shadowMapSize=i.mapSize,r.spotShadow[p]=e,r.spotShadowMap[p]=E,v++}p++}else if(S.isRectAreaLight){let e=t.get(S);e.color.copy(C).multiplyScalar(w),e.halfWidth.set(S.width*.5,0,0),e.halfHeight.set(0,S.height*.5,0),r.rectArea[m]=e,m++}else if(S.isPointLight){let e=t.get(S);if(e.color.copy(S.color).multiplyScalar(S.intensity),e.distance=S.distance,e.decay=S.decay,S.castShadow){let e=S.shadow,t=n.get(S);t.shadowIntensity=e.intensity,t.shadowBias=e.bias,t.shadowNormalBias=e.normalBias,t.shadowRadius=e.radius,t.shadowMapSize=e.mapSize,t.shadowCameraNear=e.camera.near,t.shadowCameraFar=e.camera.far,r.pointShadow[f]=t,r.pointShadowMap[f]=E,r.pointShadowMatrix[f]=S.shadow.matrix,_++}r.point[f]=e,f++}else if(S.isHemisphereLight){let e=t.get(S);e.skyColor.copy(S.color).multiplyScalar(w),e.groundColor.copy(S.groundColor).multiplyScalar(w),r.hemi[h]=e,h++}}m>0&&(e.has(`OES_texture_float_linear`)===!0?(r.rectAreaLTC1=X.LTC_FLOAT_1,r.rectAreaLTC2=X.LTC_FLOAT_2):(r.rectAreaLTC1=X.LTC_HALF_1,r.rectAreaLTC2=X.LTC_HALF_2)),r.ambient[0]=a,r.ambient[1]=o,r.ambient[2]=s;let S=r.hash;(S.sunLength!==c||S.directionalLength!==d||S.pointLength!==f||S.spotLength!==p||S.rectAreaLength!==m||S.hemiLength!==h||S.numSunShadows!==l||S.numDirectionalShadows!==g||S.numPointShadows!==_||S.numSpotShadows!==v||S.numSpotMaps!==y||S.numLightProbes!==x)&&(r.sun.length=c,r.directional.length=d,r.spot.length=p,r.rectArea.length=m,r.point.length=f,r.hemi.length=h,r.sunShadow.length=l,r.sunShadowMap.length=l,r.sunShadowMatrix.length=u,r.sunShadowCascade.length=u,r.directionalShadow.length=g,r.directionalShadowMap.length=g,r.directionalShadowMatrix.length=g,r.pointShadow.length=_,r.pointShadowMap.length=_,r.pointShadowMatrix.length=_,r.spotShadow.length=v,r.spotShadowMap.length=v,r.spotLightMatrix.length=v+y-b,r.spotLightMap.length=y,r.numSpotLightShadowsWithMaps=b,r.numLightProbes=x,S.sunLength=c,S.directionalLength=d,S.pointLength=f,S.spotLength=p,S.rectAreaLength=m,S.hemiLength=h,S.numSunShadows=l,S.numDirectionalShadows=g,S.numPointShadows=_,S.numSpotShadows=v,S.numSpotMaps=y,S.numLightProbes=x,r.version=ml++)}function c(e,t){let n=0,s=0,c=0,l=0,u=0,d=0,f=t.matrixWorldInverse;for(let t=0,p=e.length;t<p;t++){let p=e[t];if(p.isSunLight){let e=r.sun[n];e.direction.setFromMatrixPosition(p.matrixWorld),e.direction.transformDirection(f),n++}else if(p.isDirectionalLight){let e=r.directional[s];e.direction.setFromMatrixPosition(p.matrixWorld),i.setFromMatrixPosition(p.target.matrixWorld),e.direction.sub(i),e.direction.transformDirection(f),s++}else if(p.isSpotLight){let e=r.spot[l];e.position.setFromMatrixPosition(p.matrixWorld),e.position.applyMatrix4(f),e.direction.setFromMatrixPosition(p.matrixWorld),i.setFromMatrixPosition(p.target.matrixWorld),e.direction.sub(i),e.direction.transformDirection(f),l++}else if(p.isRectAreaLight){let e=r.rectArea[u];e.position.setFromMatrixPosition(p.matrixWorld),e.position.applyMatrix4(f),o.identity(),a.copy(p.matrixWorld),a.premultiply(f),o.extractRotation(a),e.halfWidth.set(p.width*.5,0,0),e.halfHeight.set(0,p.height*.5,0),e.halfWidth.applyMatrix4(o),e.halfHeight.applyMatrix4(o),u++}else if(p.isPointLight){let e=r.point[c];e.position.setFromMatrixPosition(p.matrixWorld),e.position.applyMatrix4(f),c++}else if(p.isHemisphereLight){let e=r.hemi[d];e.direction.setFromMatrixPosition(p.matrixWorld),e.direction.transformDirection(f),d++}}}return{setup:s,setupView:c,state:r}}function _l(e){let t=new gl(e),n=[],r=[],i=[];function a(e){u.camera=e,n.length=0,r.length=0,i.length=0}function o(e){e.isLightProbeGrid?i.push(e):n.push(e)}function s(e){r.push(e)}function c(){t.setup(n),i.sort((e,t)=>e.priority-t.priority||e.id-t.id)}function l(e){t.setupView(n,e)}let u={lightsArray:n,shadowsArray:r,lightProbeGridArray:i,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:a,state:u,setupLights:c,setupLightsView:l,pushLight:o,pushShadow:s}}function vl(e){let t=new WeakMap;function n(n,r=0){let i=t.get(n),a;return i===void 0?(a=new _l(e),t.set(n,[a])):r>=i.length?(a=new _l(e),i.push(a)):a=i[r],a}function r(){t=new WeakMap}return{get:n,dispose:r}}var yl=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,bl=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,xl=[new J(1,0,0),new J(-1,0,0),new J(0,1,0),new J(0,-1,0),new J(0,0,1),new J(0,0,-1)],Sl=[new J(0,-1,0),new J(0,-1,0),new J(0,0,1),new J(0,0,-1),new J(0,-1,0),new J(0,-1,0)],Cl=new qn,wl=new J,Tl=new J;function El(e,t,n){let r=new ta,i=new q,a=new q,o=new Hn,s=new Na,c=new Pa,l={},u=n.maxTextureSize,d={0:1,1:0,2:2},f=new ja({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new q},radius:{value:4}},vertexShader:yl,fragmentShader:bl}),p=f.clone();p.defines.HORIZONTAL_PASS=1;let m=new wi;m.setAttribute(`position`,new li(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let h=new Ji(m,f),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=1;let _=this.type;this.render=function(t,n,s){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||t.length===0)return;this.type===2&&(G(`WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead.`),this.type=1);let c=e.getRenderTarget(),l=e.getActiveCubeFace(),d=e.getActiveMipmapLevel(),f=e.state;f.setBlending(0),f.buffers.depth.getReversed()===!0?f.buffers.color.setClear(0,0,0,0):f.buffers.color.setClear(1,1,1,1),f.buffers.depth.setTest(!0),f.setScissorTest(!1);let p=_!==this.type;p&&n.traverse(function(e){e.material&&(Array.isArray(e.material)?e.material.forEach(e=>e.needsUpdate=!0):e.material.needsUpdate=!0)});for(let c=0,l=t.length;c<l;c++){let l=t[c],d=l.shadow;if(d===void 0){G(`WebGLShadowMap:`,l,`has no shadow.`);continue}if(d.autoUpdate===!1&&d.needsUpdate===!1)continue;i.copy(d.mapSize);let m=d.getFrameExtents();i.multiply(m),a.copy(d.mapSize),(i.x>u||i.y>u)&&(i.x>u&&(a.x=Math.floor(u/m.x),i.x=a.x*m.x,d.mapSize.x=a.x),i.y>u&&(a.y=Math.floor(u/m.y),i.y=a.y*m.y,d.mapSize.y=a.y));let h=e.state.buffers.depth.getReversed();if(d.camera._reversedDepth=h,d.map===null||p===!0){if(d.map!==null&&(d.map.depthTexture!==null&&(d.map.depthTexture.dispose(),d.map.depthTexture=null),d.map.dispose()),this.type===3){if(l.isPointLight){G(`WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.`);continue}d.map=new Wn(i.x,i.y,{format:Le,type:Ee,minFilter:R,magFilter:R,generateMipmaps:!1}),d.map.texture.name=l.name+`.shadowMap`,d.map.depthTexture=new va(i.x,i.y,Te),d.map.depthTexture.name=l.name+`.shadowMapDepth`,d.map.depthTexture.format=Ne,d.map.depthTexture.compareFunction=null,d.map.depthTexture.minFilter=ve,d.map.depthTexture.magFilter=ve}else l.isPointLight?(d.map=new Uo(i.x),d.map.depthTexture=new ya(i.x,we)):(d.map=new Wn(i.x,i.y),d.map.depthTexture=new va(i.x,i.y,we)),d.map.depthTexture.name=l.name+`.shadowMap`,d.map.depthTexture.format=Ne,this.type===1?(d.map.depthTexture.compareFunction=h?518:515,d.map.depthTexture.minFilter=R,d.map.depthTexture.magFilter=R):(d.map.depthTexture.compareFunction=null,d.map.depthTexture.minFilter=ve,d.map.depthTexture.magFilter=ve);d.camera.updateProjectionMatrix()}d.map.isWebGLCubeRenderTarget!==!0&&(d.map.width!==i.x||d.map.height!==i.y)&&d.map.setSize(i.x,i.y);let g=d.map.isWebGLCubeRenderTarget?6:d.getViewportCount();l.isPointLight!==!0&&d.updateMatrices(l,s);let _=d.camera.layers.mask&4294967294?d.camera.layers:s.layers;for(let t=0;t<g;t++){let i=d.getCamera(t);if(l.isPointLight){let e=d.camera,n=d.matrix,r=l.distance||e.far;r!==e.far&&(e.far=r,e.updateProjectionMatrix()),wl.setFromMatrixPosition(l.matrixWorld),e.position.copy(wl),Tl.copy(e.position),Tl.add(xl[t]),e.up.copy(Sl[t]),e.lookAt(Tl),e.updateMatrixWorld(),n.makeTranslation(-wl.x,-wl.y,-wl.z),Cl.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),d._frustum.setFromProjectionMatrix(Cl,e.coordinateSystem,e.reversedDepth)}if(d.map.isWebGLCubeRenderTarget)e.setRenderTarget(d.map,t),e.clear();else{t===0&&(e.setRenderTarget(d.map),e.clear());let n=d.getViewport(t);o.set(a.x*n.x,a.y*n.y,a.x*n.z,a.y*n.w),f.viewport(o)}r=d.getFrustum(t),b(n,s,i,l,_,this.type)}d.isPointLightShadow!==!0&&this.type===3&&v(d,s),d.needsUpdate=!1}_=this.type,g.needsUpdate=!1,e.setRenderTarget(c,l,d)};function v(n,r){let a=t.update(h);f.defines.VSM_SAMPLES!==n.blurSamples&&(f.defines.VSM_SAMPLES=n.blurSamples,p.defines.VSM_SAMPLES=n.blurSamples,f.needsUpdate=!0,p.needsUpdate=!0),n.mapPass===null?n.mapPass=new Wn(i.x,i.y,{format:Le,type:Ee}):(n.mapPass.width!==n.map.width||n.mapPass.height!==n.map.height)&&n.mapPass.setSize(n.map.width,n.map.height),f.uniforms.shadow_pass.value=n.map.depthTexture,f.uniforms.resolution.value.set(n.map.width,n.map.height),f.uniforms.radius.value=n.radius,e.setRenderTarget(n.mapPass),e.clear(),e.renderBufferDirect(r,null,a,f,h,null),p.uniforms.shadow_pass.value=n.mapPass.texture,p.uniforms.resolution.value.set(n.map.width,n.map.height),p.uniforms.radius.value=n.radius,e.setRenderTarget(n.map),e.clear(),e.renderBufferDirect(r,null,a,p,h,null)}function y(t,n,r,i){let a=null,o=r.isPointLight===!0?t.customDistanceMaterial:t.customDepthMaterial;if(o!==void 0)a=o;else if(a=r.isPointLight===!0?c:s,e.localClippingEnabled&&n.clipShadows===!0&&Array.isArray(n.clippingPlanes)&&n.clippingPlanes.length!==0||n.displacementMap&&n.displacementScale!==0||n.alphaMap&&n.alphaTest>0||n.map&&n.alphaTest>0||n.alphaToCoverage===!0){let e=a.uuid,t=n.uuid,r=l[e];r===void 0&&(r={},l[e]=r);let i=r[t];i===void 0&&(i=a.clone(),r[t]=i,n.addEventListener(`dispose`,x)),a=i}if(a.visible=n.visible,a.wireframe=n.wireframe,i===3?a.side=n.shadowSide===null?n.side:n.shadowSide:a.side=n.shadowSide===null?d[n.side]:n.shadowSide,a.alphaMap=n.alphaMap,a.alphaTest=n.alphaToCoverage===!0?.5:n.alphaTest,a.map=n.map,a.clipShadows=n.clipShadows,a.clippingPlanes=n.clippingPlanes,a.clipIntersection=n.clipIntersection,a.displacementMap=n.displacementMap,a.displacementScale=n.displacementScale,a.displacementBias=n.displacementBias,a.wireframeLinewidth=n.wireframeLinewidth,a.linewidth=n.linewidth,r.isPointLight===!0&&a.isMeshDistanceMaterial===!0){let t=e.properties.get(a);t.light=r}return a}function b(n,i,a,o,s,c){if(n.visible===!1)return;if(n.layers.test(s)&&(n.isMesh||n.isLine||n.isPoints)&&(n.castShadow||n.receiveShadow&&c===3)&&(!n.frustumCulled||n.intersectsFrustum(r))){n.modelViewMatrix.multiplyMatrices(a.matrixWorldInverse,n.matrixWorld);let r=t.update(n),s=n.material;if(Array.isArray(s)){let t=r.groups;for(let l=0,u=t.length;l<u;l++){let u=t[l],d=s[u.materialIndex];if(d&&d.visible){let t=y(n,d,o,c);n.onBeforeShadow(e,n,i,a,r,t,u),e.renderBufferDirect(a,null,r,t,n,u),n.onAfterShadow(e,n,i,a,r,t,u)}}}else if(s.visible){let t=y(n,s,o,c);n.onBeforeShadow(e,n,i,a,r,t,null),e.renderBufferDirect(a,null,r,t,n,null),n.onAfterShadow(e,n,i,a,r,t,null)}}let l=n.children;for(let e=0,t=l.length;e<t;e++)b(l[e],i,a,o,s,c)}function x(e){e.target.removeEventListener(`dispose`,x);for(let t in l){let n=l[t],r=e.target.uuid;r in n&&(n[r].dispose(),delete n[r])}}}function Dl(e,t){function n(){let t=!1,n=new Hn,r=null,i=new Hn(0,0,0,0);return{setMask:function(n){r!==n&&!t&&(e.colorMask(n,n,n,n),r=n)},setLocked:function(e){t=e},setClear:function(t,r,a,o,s){s===!0&&(t*=o,r*=o,a*=o),n.set(t,r,a,o),i.equals(n)===!1&&(e.clearColor(t,r,a,o),i.copy(n))},reset:function(){t=!1,r=null,i.set(-1,0,0,0)}}}function r(){let n=!1,r=!1,i=null,a=null,o=null;return{setReversed:function(e){if(r!==e){let n=t.get(`EXT_clip_control`);e?n.clipControlEXT(n.LOWER_LEFT_EXT,n.ZERO_TO_ONE_EXT):n.clipControlEXT(n.LOWER_LEFT_EXT,n.NEGATIVE_ONE_TO_ONE_EXT),r=e;let i=o;o=null,this.setClear(i)}},getReversed:function(){return r},setTest:function(t){t?oe(e.DEPTH_TEST):se(e.DEPTH_TEST)},setMask:function(t){i!==t&&!n&&(e.depthMask(t),i=t)},setFunc:function(t){if(r&&(t=qt[t]),a!==t){switch(t){case 0:e.depthFunc(e.NEVER);break;case 1:e.depthFunc(e.ALWAYS);break;case 2:e.depthFunc(e.LESS);break;case 3:e.depthFunc(e.LEQUAL);break;case 4:e.depthFunc(e.EQUAL);break;case 5:e.depthFunc(e.GEQUAL);break;case 6:e.depthFunc(e.GREATER);break;case 7:e.depthFunc(e.NOTEQUAL);break;default:e.depthFunc(e.LEQUAL)}a=t}},setLocked:function(e){n=e},setClear:function(t){o!==t&&(o=t,r&&(t=1-t),e.clearDepth(t))},reset:function(){n=!1,i=null,a=null,o=null,r=!1}}}function i(){let t=!1,n=null,r=null,i=null,a=null,o=null,s=null,c=null,l=null;return{setTest:function(n){t||(n?oe(e.STENCIL_TEST):se(e.STENCIL_TEST))},setMask:function(r){n!==r&&!t&&(e.stencilMask(r),n=r)},setFunc:function(t,n,o){(r!==t||i!==n||a!==o)&&(e.stencilFunc(t,n,o),r=t,i=n,a=o)},setOp:function(t,n,r){(o!==t||s!==n||c!==r)&&(e.stencilOp(t,n,r),o=t,s=n,c=r)},setLocked:function(e){t=e},setClear:function(t){l!==t&&(e.clearStencil(t),l=t)},reset:function(){t=!1,n=null,r=null,i=null,a=null,o=null,s=null,c=null,l=null}}}let a=new n,o=new r,s=new i,c={},l=new WeakMap,u={},d={},f={},p=new WeakMap,m=[],h=null,g=!1,_=null,v=null,y=null,b=null,x=null,S=null,C=null,w=new Or(0,0,0),T=0,E=!1,D=null,O=null,k=null,A=null,j=null,M=e.getParameter(e.MAX_COMBINED_TEXTURE_IMAGE_UNITS),N=!1,ee=0,te=e.getParameter(e.VERSION);te.indexOf(`WebGL`)===-1?te.indexOf(`OpenGL ES`)!==-1&&(ee=parseFloat(/^OpenGL ES (\d)/.exec(te)[1]),N=ee>=2):(ee=parseFloat(/^WebGL (\d)/.exec(te)[1]),N=ee>=1);let ne=null,re={},ie=e.getParameter(e.SCISSOR_BOX),P=e.getParameter(e.VIEWPORT),ae=new Hn().fromArray(ie),F=new Hn().fromArray(P);function I(t,n,r,i){let a=new Uint8Array(4),o=e.createTexture();e.bindTexture(t,o),e.texParameteri(t,e.TEXTURE_MIN_FILTER,e.NEAREST),e.texParameteri(t,e.TEXTURE_MAG_FILTER,e.NEAREST);for(let o=0;o<r;o++)t===e.TEXTURE_3D||t===e.TEXTURE_2D_ARRAY?e.texImage3D(n,0,e.RGBA,1,1,i,0,e.RGBA,e.UNSIGNED_BYTE,a):e.texImage2D(n+o,0,e.RGBA,1,1,0,e.RGBA,e.UNSIGNED_BYTE,a);return o}let L={};L[e.TEXTURE_2D]=I(e.TEXTURE_2D,e.TEXTURE_2D,1),L[e.TEXTURE_CUBE_MAP]=I(e.TEXTURE_CUBE_MAP,e.TEXTURE_CUBE_MAP_POSITIVE_X,6),L[e.TEXTURE_2D_ARRAY]=I(e.TEXTURE_2D_ARRAY,e.TEXTURE_2D_ARRAY,1,1),L[e.TEXTURE_3D]=I(e.TEXTURE_3D,e.TEXTURE_3D,1,1),a.setClear(0,0,0,1),o.setClear(1),s.setClear(0),oe(e.DEPTH_TEST),o.setFunc(3),he(!1),ge(1),oe(e.CULL_FACE),pe(0);function oe(t){u[t]!==!0&&(e.enable(t),u[t]=!0)}function se(t){u[t]!==!1&&(e.disable(t),u[t]=!1)}function ce(t,n){return f[t]!==n&&(e.bindFramebuffer(t,n),f[t]=n,t===e.DRAW_FRAMEBUFFER&&(f[e.FRAMEBUFFER]=n),t===e.FRAMEBUFFER&&(f[e.DRAW_FRAMEBUFFER]=n),!0)}function le(t,n){let r=m,i=!1;if(t){r=p.get(n),r===void 0&&(r=[],p.set(n,r));let a=t.textures;if(r.length!==a.length||r[0]!==e.COLOR_ATTACHMENT0){for(let t=0,n=a.length;t<n;t++)r[t]=e.COLOR_ATTACHMENT0+t;r.length=a.length,i=!0}}else r[0]!==e.BACK&&(r[0]=e.BACK,i=!0);i&&e.drawBuffers(r)}function ue(t){return h!==t&&(e.useProgram(t),h=t,!0)}let de={100:e.FUNC_ADD,101:e.FUNC_SUBTRACT,102:e.FUNC_REVERSE_SUBTRACT};de[103]=e.MIN,de[104]=e.MAX;let fe={200:e.ZERO,201:e.ONE,202:e.SRC_COLOR,204:e.SRC_ALPHA,210:e.SRC_ALPHA_SATURATE,208:e.DST_COLOR,206:e.DST_ALPHA,203:e.ONE_MINUS_SRC_COLOR,205:e.ONE_MINUS_SRC_ALPHA,209:e.ONE_MINUS_DST_COLOR,207:e.ONE_MINUS_DST_ALPHA,211:e.CONSTANT_COLOR,212:e.ONE_MINUS_CONSTANT_COLOR,213:e.CONSTANT_ALPHA,214:e.ONE_MINUS_CONSTANT_ALPHA};function pe(t,n,r,i,a,o,s,c,l,u){if(t===0)g===!0&&(se(e.BLEND),g=!1);else if(g===!1&&(oe(e.BLEND),g=!0),t!==5){if(t!==_||u!==E){if((v!==100||x!==100)&&(e.blendEquation(e.FUNC_ADD),v=100,x=100),u)switch(t){case 1:e.blendFuncSeparate(e.ONE,e.ONE_MINUS_SRC_ALPHA,e.ONE,e.ONE_MINUS_SRC_ALPHA);break;case 2:e.blendFunc(e.ONE,e.ONE);break;case 3:e.blendFuncSeparate(e.ZERO,e.ONE_MINUS_SRC_COLOR,e.ZERO,e.ONE);break;case 4:e.blendFuncSeparate(e.DST_COLOR,e.ONE_MINUS_SRC_ALPHA,e.ZERO,e.ONE);break;default:K(`WebGLState: Invalid blending: `,t)}else switch(t){case 1:e.blendFuncSeparate(e.SRC_ALPHA,e.ONE_MINUS_SRC_ALPHA,e.ONE,e.ONE_MINUS_SRC_ALPHA);break;case 2:e.blendFuncSeparate(e.SRC_ALPHA,e.ONE,e.ONE,e.ONE);break;case 3:K(`WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true`);break;case 4:K(`WebGLState: MultiplyBlending requires material.premultipliedAlpha = true`);break;default:K(`WebGLState: Invalid blending: `,t)}y=null,b=null,S=null,C=null,w.set(0,0,0),T=0,_=t,E=u}}else a||=n,o||=r,s||=i,(n!==v||a!==x)&&(e.blendEquationSeparate(de[n],de[a]),v=n,x=a),(r!==y||i!==b||o!==S||s!==C)&&(e.blendFuncSeparate(fe[r],fe[i],fe[o],fe[s]),y=r,b=i,S=o,C=s),(c.equals(w)===!1||l!==T)&&(e.blendColor(c.r,c.g,c.b,l),w.copy(c),T=l),_=t,E=!1}function me(t,n){t.side===2?se(e.CULL_FACE):oe(e.CULL_FACE);let r=t.side===1;n&&(r=!r),he(r),t.blending===1&&t.transparent===!1?pe(0):pe(t.blending,t.blendEquation,t.blendSrc,t.blendDst,t.blendEquationAlpha,t.blendSrcAlpha,t.blendDstAlpha,t.blendColor,t.blendAlpha,t.premultipliedAlpha),o.setFunc(t.depthFunc),o.setTest(t.depthTest),o.setMask(t.depthWrite),a.setMask(t.colorWrite);let i=t.stencilWrite;s.setTest(i),i&&(s.setMask(t.stencilWriteMask),s.setFunc(t.stencilFunc,t.stencilRef,t.stencilFuncMask),s.setOp(t.stencilFail,t.stencilZFail,t.stencilZPass)),ve(t.polygonOffset,t.polygonOffsetFactor,t.polygonOffsetUnits),t.alphaToCoverage===!0?oe(e.SAMPLE_ALPHA_TO_COVERAGE):se(e.SAMPLE_ALPHA_TO_COVERAGE)}function he(t){D!==t&&(t?e.frontFace(e.CW):e.frontFace(e.CCW),D=t)}function ge(t){t===0?se(e.CULL_FACE):(oe(e.CULL_FACE),t!==O&&(t===1?e.cullFace(e.BACK):t===2?e.cullFace(e.FRONT):e.cullFace(e.FRONT_AND_BACK))),O=t}function _e(t){t!==k&&(N&&e.lineWidth(t),k=t)}function ve(t,n,r){t?(oe(e.POLYGON_OFFSET_FILL),(A!==n||j!==r)&&(A=n,j=r,o.getReversed()&&(n=-n,r=-r),e.polygonOffset(n,r))):se(e.POLYGON_OFFSET_FILL)}function ye(t){t?oe(e.SCISSOR_TEST):se(e.SCISSOR_TEST)}function be(t){t===void 0&&(t=e.TEXTURE0+M-1),ne!==t&&(e.activeTexture(t),ne=t)}function R(t,n,r){r===void 0&&(r=ne===null?e.TEXTURE0+M-1:ne);let i=re[r];i===void 0&&(i={type:void 0,texture:void 0},re[r]=i),(i.type!==t||i.texture!==n)&&(ne!==r&&(e.activeTexture(r),ne=r),e.bindTexture(t,n||L[t]),i.type=t,i.texture=n)}function z(){let t=re[ne];t!==void 0&&t.type!==void 0&&(e.bindTexture(t.type,null),t.type=void 0,t.texture=void 0)}function B(){try{e.compressedTexImage2D(...arguments)}catch(e){K(`WebGLState:`,e)}}function xe(){try{e.compressedTexImage3D(...arguments)}catch(e){K(`WebGLState:`,e)}}function V(){try{e.texSubImage2D(...arguments)}catch(e){K(`WebGLState:`,e)}}function Se(){try{e.texSubImage3D(...arguments)}catch(e){K(`WebGLState:`,e)}}function Ce(){try{e.compressedTexSubImage2D(...arguments)}catch(e){K(`WebGLState:`,e)}}function H(){try{e.compressedTexSubImage3D(...arguments)}catch(e){K(`WebGLState:`,e)}}function we(){try{e.texStorage2D(...arguments)}catch(e){K(`WebGLState:`,e)}}function Te(){try{e.texStorage3D(...arguments)}catch(e){K(`WebGLState:`,e)}}function Ee(){try{e.texImage2D(...arguments)}catch(e){K(`WebGLState:`,e)}}function De(){try{e.texImage3D(...arguments)}catch(e){K(`WebGLState:`,e)}}function Oe(t){return d[t]===void 0?e.getParameter(t):d[t]}function ke(t,n){d[t]!==n&&(e.pixelStorei(t,n),d[t]=n)}function U(t){ae.equals(t)===!1&&(e.scissor(t.x,t.y,t.z,t.w),ae.copy(t))}function W(t){F.equals(t)===!1&&(e.viewport(t.x,t.y,t.z,t.w),F.copy(t))}function Ae(t,n){let r=l.get(n);r===void 0&&(r=new WeakMap,l.set(n,r));let i=r.get(t);i===void 0&&(i=e.getUniformBlockIndex(n,t.name),e.uniformBlockBinding(n,i,i),r.set(t,i))}function je(t,n,r){let i=l.get(n).get(t);c[i]!==r&&(e.bindBufferBase(e.UNIFORM_BUFFER,i,r),c[i]=r)}function Me(){e.disable(e.BLEND),e.disable(e.CULL_FACE),e.disable(e.DEPTH_TEST),e.disable(e.POLYGON_OFFSET_FILL),e.disable(e.SCISSOR_TEST),e.disable(e.STENCIL_TEST),e.disable(e.SAMPLE_ALPHA_TO_COVERAGE),e.blendEquation(e.FUNC_ADD),e.blendFunc(e.ONE,e.ZERO),e.blendFuncSeparate(e.ONE,e.ZERO,e.ONE,e.ZERO),e.blendColor(0,0,0,0),e.colorMask(!0,!0,!0,!0),e.clearColor(0,0,0,0),e.depthMask(!0),e.depthFunc(e.LESS),o.setReversed(!1),e.clearDepth(1),e.stencilMask(4294967295),e.stencilFunc(e.ALWAYS,0,4294967295),e.stencilOp(e.KEEP,e.KEEP,e.KEEP),e.clearStencil(0),e.cullFace(e.BACK),e.frontFace(e.CCW),e.polygonOffset(0,0),e.activeTexture(e.TEXTURE0),e.bindFramebuffer(e.FRAMEBUFFER,null),e.bindFramebuffer(e.DRAW_FRAMEBUFFER,null),e.bindFramebuffer(e.READ_FRAMEBUFFER,null),e.useProgram(null),e.lineWidth(1),e.scissor(0,0,e.canvas.width,e.canvas.height),e.viewport(0,0,e.canvas.width,e.canvas.height),e.pixelStorei(e.PACK_ALIGNMENT,4),e.pixelStorei(e.UNPACK_ALIGNMENT,4),e.pixelStorei(e.UNPACK_FLIP_Y_WEBGL,!1),e.pixelStorei(e.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),e.pixelStorei(e.UNPACK_COLORSPACE_CONVERSION_WEBGL,e.BROWSER_DEFAULT_WEBGL),e.pixelStorei(e.PACK_ROW_LENGTH,0),e.pixelStorei(e.PACK_SKIP_PIXELS,0),e.pixelStorei(e.PACK_SKIP_ROWS,0),e.pixelStorei(e.UNPACK_ROW_LENGTH,0),e.pixelStorei(e.UNPACK_IMAGE_HEIGHT,0),e.pixelStorei(e.UNPACK_SKIP_PIXELS,0),e.pixelStorei(e.UNPACK_SKIP_ROWS,0),e.pixelStorei(e.UNPACK_SKIP_IMAGES,0),u={},d={},ne=null,re={},f={},c={},p=new WeakMap,m=[],h=null,g=!1,_=null,v=null,y=null,b=null,x=null,S=null,C=null,w=new Or(0,0,0),T=0,E=!1,D=null,O=null,k=null,A=null,j=null,ae.set(0,0,e.canvas.width,e.canvas.height),F.set(0,0,e.canvas.width,e.canvas.height),a.reset(),o.reset(),s.reset()}return{buffers:{color:a,depth:o,stencil:s},enable:oe,disable:se,bindFramebuffer:ce,drawBuffers:le,useProgram:ue,setBlending:pe,setMaterial:me,setFlipSided:he,setCullFace:ge,setLineWidth:_e,setPolygonOffset:ve,setScissorTest:ye,activeTexture:be,bindTexture:R,unbindTexture:z,compressedTexImage2D:B,compressedTexImage3D:xe,texImage2D:Ee,texImage3D:De,pixelStorei:ke,getParameter:Oe,updateUBOMapping:Ae,uniformBlockBinding:je,texStorage2D:we,texStorage3D:Te,texSubImage2D:V,texSubImage3D:Se,compressedTexSubImage2D:Ce,compressedTexSubImage3D:H,scissor:U,viewport:W,reset:Me}}function Ol(e,t,n,r,i,a,o){let s=t.has(`WEBGL_multisampled_render_to_texture`)?t.get(`WEBGL_multisampled_render_to_texture`):null,c=typeof navigator>`u`?!1:/OculusBrowser/g.test(navigator.userAgent),l=new q,u=new WeakMap,d=new Set,f,p=new WeakMap,m=new Set,h=new FinalizationRegistry(e=>m.delete(e)),g=!1;try{g=typeof OffscreenCanvas<`u`&&new OffscreenCanvas(1,1).getContext(`2d`)!==null}catch{}function _(e,t){return g?new OffscreenCanvas(e,t):Bt(`canvas`)}function v(e,t,n){let r=1,i=je(e);if((i.width>n||i.height>n)&&(r=n/Math.max(i.width,i.height)),r<1){if(typeof HTMLImageElement<`u`&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<`u`&&e instanceof HTMLCanvasElement||typeof ImageBitmap<`u`&&e instanceof ImageBitmap||typeof VideoFrame<`u`&&e instanceof VideoFrame){let n=Math.floor(r*i.width),a=Math.floor(r*i.height);f===void 0&&(f=_(n,a));let o=t?_(n,a):f;return o.width=n,o.height=a,o.getContext(`2d`).drawImage(e,0,0,n,a),G(`WebGLRenderer: Texture has been resized from (`+i.width+`x`+i.height+`) to (`+n+`x`+a+`).`),o}return`data`in e&&G(`WebGLRenderer: Image in DataTexture is too big (`+i.width+`x`+i.height+`).`),e}return e}function y(e){return e.generateMipmaps}function b(t){e.generateMipmap(t)}function x(t){return t.isWebGLCubeRenderTarget?e.TEXTURE_CUBE_MAP:t.isWebGL3DRenderTarget?e.TEXTURE_3D:t.isWebGLArrayRenderTarget||t.isCompressedArrayTexture?e.TEXTURE_2D_ARRAY:e.TEXTURE_2D}function S(n,r,i,a,o,s=!1){if(n!==null){if(e[n]!==void 0)return e[n];G(`WebGLRenderer: Attempt to use non-existing WebGL internal format '`+n+`'`)}let c;a&&(c=t.get(`EXT_texture_norm16`),c||G(`WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension`));let l=r;if(r===e.RED&&(i===e.FLOAT&&(l=e.R32F),i===e.HALF_FLOAT&&(l=e.R16F),i===e.UNSIGNED_BYTE&&(l=e.R8),i===e.UNSIGNED_SHORT&&c&&(l=c.R16_EXT),i===e.SHORT&&c&&(l=c.R16_SNORM_EXT)),r===e.RED_INTEGER&&(i===e.UNSIGNED_BYTE&&(l=e.R8UI),i===e.UNSIGNED_SHORT&&(l=e.R16UI),i===e.UNSIGNED_INT&&(l=e.R32UI),i===e.BYTE&&(l=e.R8I),i===e.SHORT&&(l=e.R16I),i===e.INT&&(l=e.R32I)),r===e.RG&&(i===e.FLOAT&&(l=e.RG32F),i===e.HALF_FLOAT&&(l=e.RG16F),i===e.UNSIGNED_BYTE&&(l=e.RG8),i===e.UNSIGNED_SHORT&&c&&(l=c.RG16_EXT),i===e.SHORT&&c&&(l=c.RG16_SNORM_EXT)),r===e.RG_INTEGER&&(i===e.UNSIGNED_BYTE&&(l=e.RG8UI),i===e.UNSIGNED_SHORT&&(l=e.RG16UI),i===e.UNSIGNED_INT&&(l=e.RG32UI),i===e.BYTE&&(l=e.RG8I),i===e.SHORT&&(l=e.RG16I),i===e.INT&&(l=e.RG32I)),r===e.RGB_INTEGER&&(i===e.UNSIGNED_BYTE&&(l=e.RGB8UI),i===e.UNSIGNED_SHORT&&(l=e.RGB16UI),i===e.UNSIGNED_INT&&(l=e.RGB32UI),i===e.BYTE&&(l=e.RGB8I),i===e.SHORT&&(l=e.RGB16I),i===e.INT&&(l=e.RGB32I)),r===e.RGBA_INTEGER&&(i===e.UNSIGNED_BYTE&&(l=e.RGBA8UI),i===e.UNSIGNED_SHORT&&(l=e.RGBA16UI),i===e.UNSIGNED_INT&&(l=e.RGBA32UI),i===e.BYTE&&(l=e.RGBA8I),i===e.SHORT&&(l=e.RGBA16I),i===e.INT&&(l=e.RGBA32I)),r===e.RGB&&(i===e.UNSIGNED_SHORT&&c&&(l=c.RGB16_EXT),i===e.SHORT&&c&&(l=c.RGB16_SNORM_EXT),i===e.UNSIGNED_INT_5_9_9_9_REV&&(l=e.RGB9_E5),i===e.UNSIGNED_INT_10F_11F_11F_REV&&(l=e.R11F_G11F_B10F)),r===e.RGBA){let t=s?Mt:jn.getTransfer(o);i===e.FLOAT&&(l=e.RGBA32F),i===e.HALF_FLOAT&&(l=e.RGBA16F),i===e.UNSIGNED_BYTE&&(l=t===`srgb`?e.SRGB8_ALPHA8:e.RGBA8),i===e.UNSIGNED_SHORT&&c&&(l=c.RGBA16_EXT),i===e.SHORT&&c&&(l=c.RGBA16_SNORM_EXT),i===e.UNSIGNED_SHORT_4_4_4_4&&(l=e.RGBA4),i===e.UNSIGNED_SHORT_5_5_5_1&&(l=e.RGB5_A1)}return(l===e.R16F||l===e.R32F||l===e.RG16F||l===e.RG32F||l===e.RGBA16F||l===e.RGBA32F)&&t.get(`EXT_color_buffer_float`),l}function C(t,n){let r;return t?n===null||n===1014||n===1020?r=e.DEPTH24_STENCIL8:n===1015?r=e.DEPTH32F_STENCIL8:n===1012&&(r=e.DEPTH24_STENCIL8,G(`DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.`)):n===null||n===1014||n===1020?r=e.DEPTH_COMPONENT24:n===1015?r=e.DEPTH_COMPONENT32F:n===1012&&(r=e.DEPTH_COMPONENT16),r}function w(e,t){return y(e)===!0||e.isFramebufferTexture&&e.minFilter!==1003&&e.minFilter!==1006?Math.log2(Math.max(t.width,t.height))+1:e.mipmaps.length>0?e.mipmaps.length:e.isCompressedTexture&&Array.isArray(e.image)?t.mipmaps.length:1}function T(e){let t=new WeakRef(e);r.get(e).__ref=t,m.add(t),h.register(e,t,t)}function E(e){let t=r.get(e).__ref;t!==void 0&&(m.delete(t),h.unregister(t))}function D(e){k(e.target)}function O(e){A(e.target)}function k(e){e.removeEventListener(`dispose`,D),E(e),M(e),e.isVideoTexture&&u.delete(e),e.isHTMLTexture&&d.delete(e)}function A(e){e.removeEventListener(`dispose`,O),E(e),ee(e)}function j(){for(let e of m){let t=e.deref();t!==void 0&&(t.isRenderTarget===!0?A(t):k(t))}m.clear(),d.clear()}function M(e){let t=r.get(e);if(t.__webglInit===void 0)return;let n=e.source,i=p.get(n);if(i){let r=i[t.__cacheKey];r.usedTimes--,r.usedTimes===0&&N(e),Object.keys(i).length===0&&p.delete(n)}r.remove(e)}function N(t){let n=r.get(t);e.deleteTexture(n.__webglTexture);let i=t.source,a=p.get(i);delete a[n.__cacheKey],o.memory.textures--}function ee(t){let n=r.get(t);n.__depthDisposeCallback&&n.__depthDisposeCallback();let i=t.depthTexture;if(i&&i.renderTarget===t&&k(i),t.isWebGLCubeRenderTarget)for(let t=0;t<6;t++){if(Array.isArray(n.__webglFramebuffer[t]))for(let r=0;r<n.__webglFramebuffer[t].length;r++)e.deleteFramebuffer(n.__webglFramebuffer[t][r]);else e.deleteFramebuffer(n.__webglFramebuffer[t]);n.__webglDepthbuffer&&e.deleteRenderbuffer(n.__webglDepthbuffer[t])}else{if(Array.isArray(n.__webglFramebuffer))for(let t=0;t<n.__webglFramebuffer.length;t++)e.deleteFramebuffer(n.__webglFramebuffer[t]);else e.deleteFramebuffer(n.__webglFramebuffer);if(n.__webglDepthbuffer&&e.deleteRenderbuffer(n.__webglDepthbuffer),n.__webglMultisampledFramebuffer&&e.deleteFramebuffer(n.__webglMultisampledFramebuffer),n.__webglColorRenderbuffer)for(let t=0;t<n.__webglColorRenderbuffer.length;t++)n.__webglColorRenderbuffer[t]&&e.deleteRenderbuffer(n.__webglColorRenderbuffer[t]);n.__webglDepthRenderbuffer&&e.deleteRenderbuffer(n.__webglDepthRenderbuffer)}let a=t.textures;for(let t=0,n=a.length;t<n;t++){let n=r.get(a[t]);n.__webglTexture&&(e.deleteTexture(n.__webglTexture),o.memory.textures--),r.remove(a[t])}r.remove(t)}let te=0;function ne(){te=0}function re(){return te}function ie(e){te=e}function P(){let e=te;return e>=i.maxTextures&&G(`WebGLTextures: Trying to use `+(e+1)+` texture units while this GPU supports only `+i.maxTextures),te+=1,e}function ae(e){let t=[];return t.push(e.wrapS),t.push(e.wrapT),t.push(e.wrapR||0),t.push(e.magFilter),t.push(e.minFilter),t.push(e.anisotropy),t.push(e.internalFormat),t.push(e.format),t.push(e.type),t.push(e.generateMipmaps),t.push(e.mipmapsAutoUpdate),t.push(e.premultiplyAlpha),t.push(e.flipY),t.push(e.unpackAlignment),t.push(e.colorSpace),t.join()}function F(t,i){let a=r.get(t);if(t.isVideoTexture&&W(t),t.isRenderTargetTexture===!1&&t.isExternalTexture!==!0&&t.version>0&&a.__version!==t.version){let e=t.image;if(e===null)G(`WebGLRenderer: Texture marked for update but no image data found.`);else if(e.complete===!1)G(`WebGLRenderer: Texture marked for update but image is incomplete`);else{me(a,t,i);return}}else t.isExternalTexture&&(a.__webglTexture=t.sourceTexture?t.sourceTexture:null);n.bindTexture(e.TEXTURE_2D,a.__webglTexture,e.TEXTURE0+i)}function I(t,i){let a=r.get(t);t.isRenderTargetTexture===!1&&t.version>0&&a.__version!==t.version?me(a,t,i):(t.isExternalTexture&&(a.__webglTexture=t.sourceTexture?t.sourceTexture:null),n.bindTexture(e.TEXTURE_2D_ARRAY,a.__webglTexture,e.TEXTURE0+i))}function L(t,i){let a=r.get(t);t.isRenderTargetTexture===!1&&t.version>0&&a.__version!==t.version?me(a,t,i):n.bindTexture(e.TEXTURE_3D,a.__webglTexture,e.TEXTURE0+i)}function oe(t,i){let a=r.get(t);t.version>0&&a.__version!==t.version?xe(a,t,i):n.bindTexture(e.TEXTURE_CUBE_MAP,a.__webglTexture,e.TEXTURE0+i)}let se={[he]:e.REPEAT,[ge]:e.CLAMP_TO_EDGE,[_e]:e.MIRRORED_REPEAT},ce={[ve]:e.NEAREST,[ye]:e.NEAREST_MIPMAP_NEAREST,[be]:e.NEAREST_MIPMAP_LINEAR,[R]:e.LINEAR,[z]:e.LINEAR_MIPMAP_NEAREST,[B]:e.LINEAR_MIPMAP_LINEAR},le={512:e.NEVER,519:e.ALWAYS,513:e.LESS,515:e.LEQUAL,514:e.EQUAL,518:e.GEQUAL,516:e.GREATER,517:e.NOTEQUAL};function ue(n,a){if(a.type===1015&&t.has(`OES_texture_float_linear`)===!1&&(a.magFilter===1006||a.magFilter===1007||a.magFilter===1005||a.magFilter===1008||a.minFilter===1006||a.minFilter===1007||a.minFilter===1005||a.minFilter===1008)&&G(`WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device.`),e.texParameteri(n,e.TEXTURE_WRAP_S,se[a.wrapS]),e.texParameteri(n,e.TEXTURE_WRAP_T,se[a.wrapT]),(n===e.TEXTURE_3D||n===e.TEXTURE_2D_ARRAY)&&e.texParameteri(n,e.TEXTURE_WRAP_R,se[a.wrapR]),e.texParameteri(n,e.TEXTURE_MAG_FILTER,ce[a.magFilter]),e.texParameteri(n,e.TEXTURE_MIN_FILTER,ce[a.minFilter]),a.compareFunction&&(e.texParameteri(n,e.TEXTURE_COMPARE_MODE,e.COMPARE_REF_TO_TEXTURE),e.texParameteri(n,e.TEXTURE_COMPARE_FUNC,le[a.compareFunction])),t.has(`EXT_texture_filter_anisotropic`)===!0){if(a.magFilter===1003||a.minFilter!==1005&&a.minFilter!==1008||a.type===1015&&t.has(`OES_texture_float_linear`)===!1)return;if(a.anisotropy>1||r.get(a).__currentAnisotropy){let o=t.get(`EXT_texture_filter_anisotropic`);e.texParameterf(n,o.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(a.anisotropy,i.getMaxAnisotropy())),r.get(a).__currentAnisotropy=a.anisotropy}}}function de(t,n){let r=!1;t.__webglInit===void 0&&(t.__webglInit=!0,n.addEventListener(`dispose`,D),T(n));let i=n.source,a=p.get(i);a===void 0&&(a={},p.set(i,a));let s=ae(n);if(s!==t.__cacheKey){a[s]===void 0&&(a[s]={texture:e.createTexture(),usedTimes:0},o.memory.textures++,r=!0),a[s].usedTimes++;let i=a[t.__cacheKey];i!==void 0&&(a[t.__cacheKey].usedTimes--,i.usedTimes===0&&N(n)),t.__cacheKey=s,t.__webglTexture=a[s].texture}return r}function fe(e,t,n){return Math.floor(Math.floor(e/n)/t)}function pe(t,r,i,a){let o=t.updateRanges;if(o.length===0)n.texSubImage2D(e.TEXTURE_2D,0,0,0,r.width,r.height,i,a,r.data);else{o.sort((e,t)=>e.start-t.start);let s=0;for(let e=1;e<o.length;e++){let t=o[s],n=o[e],i=t.start+t.count,a=fe(n.start,r.width,4),c=fe(t.start,r.width,4);n.start<=i+1&&a===c&&fe(n.start+n.count-1,r.width,4)===a?t.count=Math.max(t.count,n.start+n.count-t.start):(++s,o[s]=n)}o.length=s+1;let c=n.getParameter(e.UNPACK_ROW_LENGTH),l=n.getParameter(e.UNPACK_SKIP_PIXELS),u=n.getParameter(e.UNPACK_SKIP_ROWS);n.pixelStorei(e.UNPACK_ROW_LENGTH,r.width);for(let t=0,s=o.length;t<s;t++){let s=o[t],c=Math.floor(s.start/4),l=Math.ceil(s.count/4),u=c%r.width,d=Math.floor(c/r.width),f=l;n.pixelStorei(e.UNPACK_SKIP_PIXELS,u),n.pixelStorei(e.UNPACK_SKIP_ROWS,d),n.texSubImage2D(e.TEXTURE_2D,0,u,d,f,1,i,a,r.data)}t.clearUpdateRanges(),n.pixelStorei(e.UNPACK_ROW_LENGTH,c),n.pixelStorei(e.UNPACK_SKIP_PIXELS,l),n.pixelStorei(e.UNPACK_SKIP_ROWS,u)}}function me(t,o,s){let c=e.TEXTURE_2D;(o.isDataArrayTexture||o.isCompressedArrayTexture)&&(c=e.TEXTURE_2D_ARRAY),o.isData3DTexture&&(c=e.TEXTURE_3D);let l=de(t,o),u=o.source;n.bindTexture(c,t.__webglTexture,e.TEXTURE0+s);let f=r.get(u);if(u.version!==f.__version||l===!0){if(n.activeTexture(e.TEXTURE0+s),!(typeof ImageBitmap<`u`&&o.image instanceof ImageBitmap)){let t=jn.getPrimaries(jn.workingColorSpace),r=o.colorSpace===``?null:jn.getPrimaries(o.colorSpace),i=o.colorSpace===``||t===r?e.NONE:e.BROWSER_DEFAULT_WEBGL;n.pixelStorei(e.UNPACK_FLIP_Y_WEBGL,o.flipY),n.pixelStorei(e.UNPACK_PREMULTIPLY_ALPHA_WEBGL,o.premultiplyAlpha),n.pixelStorei(e.UNPACK_COLORSPACE_CONVERSION_WEBGL,i)}n.pixelStorei(e.UNPACK_ALIGNMENT,o.unpackAlignment);let t=v(o.image,!1,i.maxTextureSize);t=Ae(o,t);let r=a.convert(o.format,o.colorSpace),p=a.convert(o.type),m=S(o.internalFormat,r,p,o.normalized,o.colorSpace,o.isVideoTexture);ue(c,o);let h,g=o.mipmaps,_=o.isVideoTexture!==!0,x=f.__version===void 0||l===!0,T=u.dataReady,E=w(o,t);if(o.isDepthTexture)m=C(o.format===Pe,o.type),x&&(_?n.texStorage2D(e.TEXTURE_2D,1,m,t.width,t.height):n.texImage2D(e.TEXTURE_2D,0,m,t.width,t.height,0,r,p,null));else if(o.isDataTexture){if(g.length>0){_&&x&&n.texStorage2D(e.TEXTURE_2D,E,m,g[0].width,g[0].height);for(let t=0,i=g.length;t<i;t++)h=g[t],_?T&&n.texSubImage2D(e.TEXTURE_2D,t,0,0,h.width,h.height,r,p,h.data):n.texImage2D(e.TEXTURE_2D,t,m,h.width,h.height,0,r,p,h.data);o.generateMipmaps=!1}else _?(x&&n.texStorage2D(e.TEXTURE_2D,E,m,t.width,t.height),T&&pe(o,t,r,p)):n.texImage2D(e.TEXTURE_2D,0,m,t.width,t.height,0,r,p,t.data)}else if(o.isCompressedTexture){if(o.isCompressedArrayTexture){_&&x&&n.texStorage3D(e.TEXTURE_2D_ARRAY,E,m,g[0].width,g[0].height,t.depth);for(let i=0,a=g.length;i<a;i++)if(h=g[i],o.format!==1023){if(r!==null){if(_){if(T){if(o.layerUpdates.size>0){let t=ko(h.width,h.height,o.format,o.type);for(let a of o.layerUpdates){let o=h.data.subarray(a*t/h.data.BYTES_PER_ELEMENT,(a+1)*t/h.data.BYTES_PER_ELEMENT);n.compressedTexSubImage3D(e.TEXTURE_2D_ARRAY,i,0,0,a,h.width,h.height,1,r,o)}}else n.compressedTexSubImage3D(e.TEXTURE_2D_ARRAY,i,0,0,0,h.width,h.height,t.depth,r,h.data)}}else n.compressedTexImage3D(e.TEXTURE_2D_ARRAY,i,m,h.width,h.height,t.depth,0,h.data,0,0)}else G(`WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()`)}else _?T&&n.texSubImage3D(e.TEXTURE_2D_ARRAY,i,0,0,0,h.width,h.height,t.depth,r,p,h.data):n.texImage3D(e.TEXTURE_2D_ARRAY,i,m,h.width,h.height,t.depth,0,r,p,h.data);o.layerUpdates.size>0&&o.clearLayerUpdates()}else{_&&x&&n.texStorage2D(e.TEXTURE_2D,E,m,g[0].width,g[0].height);for(let t=0,i=g.length;t<i;t++)h=g[t],o.format===1023?_?T&&n.texSubImage2D(e.TEXTURE_2D,t,0,0,h.width,h.height,r,p,h.data):n.texImage2D(e.TEXTURE_2D,t,m,h.width,h.height,0,r,p,h.data):r===null?G(`WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()`):_?T&&n.compressedTexSubImage2D(e.TEXTURE_2D,t,0,0,h.width,h.height,r,h.data):n.compressedTexImage2D(e.TEXTURE_2D,t,m,h.width,h.height,0,h.data)}}else if(o.isDataArrayTexture){if(_){if(x&&n.texStorage3D(e.TEXTURE_2D_ARRAY,E,m,t.width,t.height,t.depth),T){if(o.layerUpdates.size>0){let i=ko(t.width,t.height,o.format,o.type);for(let a of o.layerUpdates){let o=t.data.subarray(a*i/t.data.BYTES_PER_ELEMENT,(a+1)*i/t.data.BYTES_PER_ELEMENT);n.texSubImage3D(e.TEXTURE_2D_ARRAY,0,0,0,a,t.width,t.height,1,r,p,o)}o.clearLayerUpdates()}else n.texSubImage3D(e.TEXTURE_2D_ARRAY,0,0,0,0,t.width,t.height,t.depth,r,p,t.data)}}else n.texImage3D(e.TEXTURE_2D_ARRAY,0,m,t.width,t.height,t.depth,0,r,p,t.data)}else if(o.isData3DTexture)_?(x&&n.texStorage3D(e.TEXTURE_3D,E,m,t.width,t.height,t.depth),T&&n.texSubImage3D(e.TEXTURE_3D,0,0,0,0,t.width,t.height,t.depth,r,p,t.data)):n.texImage3D(e.TEXTURE_3D,0,m,t.width,t.height,t.depth,0,r,p,t.data);else if(o.isFramebufferTexture){if(x){if(_)n.texStorage2D(e.TEXTURE_2D,E,m,t.width,t.height);else{let i=t.width,a=t.height;for(let t=0;t<E;t++)n.texImage2D(e.TEXTURE_2D,t,m,i,a,0,r,p,null),i>>=1,a>>=1}}}else if(o.isHTMLTexture){if(`texElementImage2D`in e){let n=e.canvas;if(n.hasAttribute(`layoutsubtree`)||n.setAttribute(`layoutsubtree`,`true`),t.parentNode!==n){n.appendChild(t),d.add(o),n.onpaint=e=>{let t=e.changedElements;for(let e of d)t.includes(e.image)&&(e.needsUpdate=!0)},n.requestPaint();return}if(e.texElementImage2D.length===3)e.texElementImage2D(e.TEXTURE_2D,e.RGBA8,t);else{let n=e.RGBA,r=e.RGBA,i=e.UNSIGNED_BYTE;e.texElementImage2D(e.TEXTURE_2D,0,n,r,i,t)}e.texParameteri(e.TEXTURE_2D,e.TEXTURE_MIN_FILTER,e.LINEAR),e.texParameteri(e.TEXTURE_2D,e.TEXTURE_WRAP_S,e.CLAMP_TO_EDGE),e.texParameteri(e.TEXTURE_2D,e.TEXTURE_WRAP_T,e.CLAMP_TO_EDGE)}}else if(g.length>0){if(_&&x){let t=je(g[0]);n.texStorage2D(e.TEXTURE_2D,E,m,t.width,t.height)}for(let t=0,i=g.length;t<i;t++)h=g[t],_?T&&n.texSubImage2D(e.TEXTURE_2D,t,0,0,r,p,h):n.texImage2D(e.TEXTURE_2D,t,m,r,p,h);o.generateMipmaps=!1}else if(_){if(x){let r=je(t);n.texStorage2D(e.TEXTURE_2D,E,m,r.width,r.height)}T&&n.texSubImage2D(e.TEXTURE_2D,0,0,0,r,p,t)}else n.texImage2D(e.TEXTURE_2D,0,m,r,p,t);y(o)&&o.mipmapsAutoUpdate===!0&&b(c),f.__version=u.version,o.onUpdate&&o.onUpdate(o)}t.__version=o.version}function xe(t,o,s){if(o.image.length!==6)return;let c=de(t,o),l=o.source;n.bindTexture(e.TEXTURE_CUBE_MAP,t.__webglTexture,e.TEXTURE0+s);let u=r.get(l);if(l.version!==u.__version||c===!0){n.activeTexture(e.TEXTURE0+s);let t=jn.getPrimaries(jn.workingColorSpace),r=o.colorSpace===``?null:jn.getPrimaries(o.colorSpace),d=o.colorSpace===``||t===r?e.NONE:e.BROWSER_DEFAULT_WEBGL;n.pixelStorei(e.UNPACK_FLIP_Y_WEBGL,o.flipY),n.pixelStorei(e.UNPACK_PREMULTIPLY_ALPHA_WEBGL,o.premultiplyAlpha),n.pixelStorei(e.UNPACK_ALIGNMENT,o.unpackAlignment),n.pixelStorei(e.UNPACK_COLORSPACE_CONVERSION_WEBGL,d);let f=o.isCompressedTexture||o.image[0].isCompressedTexture,p=o.image[0]&&o.image[0].isDataTexture,m=[];for(let e=0;e<6;e++)!f&&!p?m[e]=v(o.image[e],!0,i.maxCubemapSize):m[e]=p?o.image[e].image:o.image[e],m[e]=Ae(o,m[e]);let h=m[0],g=a.convert(o.format,o.colorSpace),_=a.convert(o.type),x=S(o.internalFormat,g,_,o.normalized,o.colorSpace),T=o.isVideoTexture!==!0,E=u.__version===void 0||c===!0,D=l.dataReady,O=w(o,h);ue(e.TEXTURE_CUBE_MAP,o);let k;if(o.isDepthTexture){if(x=C(o.format===Pe,o.type),E){if(T)n.texStorage2D(e.TEXTURE_CUBE_MAP,1,x,h.width,h.height);else for(let t=0;t<6;t++)n.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,0,x,h.width,h.height,0,g,_,null)}}else if(f){T&&E&&n.texStorage2D(e.TEXTURE_CUBE_MAP,O,x,h.width,h.height);for(let t=0;t<6;t++){k=m[t].mipmaps;for(let r=0;r<k.length;r++){let i=k[r];o.format===1023?T?D&&n.texSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,r,0,0,i.width,i.height,g,_,i.data):n.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,r,x,i.width,i.height,0,g,_,i.data):g===null?G(`WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()`):T?D&&n.compressedTexSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,r,0,0,i.width,i.height,g,i.data):n.compressedTexImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,r,x,i.width,i.height,0,i.data)}}}else{if(k=o.mipmaps,T&&E){k.length>0&&O++;let t=je(m[0]);n.texStorage2D(e.TEXTURE_CUBE_MAP,O,x,t.width,t.height)}for(let t=0;t<6;t++)if(p){T?D&&n.texSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,0,0,0,m[t].width,m[t].height,g,_,m[t].data):n.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,0,x,m[t].width,m[t].height,0,g,_,m[t].data);for(let r=0;r<k.length;r++){let i=k[r].image[t].image;T?D&&n.texSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,r+1,0,0,i.width,i.height,g,_,i.data):n.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,r+1,x,i.width,i.height,0,g,_,i.data)}}else{T?D&&n.texSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,0,0,0,g,_,m[t]):n.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,0,x,g,_,m[t]);for(let r=0;r<k.length;r++){let i=k[r];T?D&&n.texSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,r+1,0,0,g,_,i.image[t]):n.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,r+1,x,g,_,i.image[t])}}}y(o)&&o.mipmapsAutoUpdate===!0&&b(e.TEXTURE_CUBE_MAP),u.__version=l.version,o.onUpdate&&o.onUpdate(o)}t.__version=o.version}function V(t,i,o,c,l,u){let d=a.convert(o.format,o.colorSpace),f=a.convert(o.type),p=S(o.internalFormat,d,f,o.normalized,o.colorSpace),m=r.get(i),h=r.get(o);if(h.__renderTarget=i,!m.__hasExternalTextures){let t=Math.max(1,i.width>>u),r=Math.max(1,i.height>>u);l===e.TEXTURE_3D||l===e.TEXTURE_2D_ARRAY?n.texImage3D(l,u,p,t,r,i.depth,0,d,f,null):n.texImage2D(l,u,p,t,r,0,d,f,null)}n.bindFramebuffer(e.FRAMEBUFFER,t),U(i)?s.framebufferTexture2DMultisampleEXT(e.FRAMEBUFFER,c,l,h.__webglTexture,0,ke(i)):(l===e.TEXTURE_2D||l>=e.TEXTURE_CUBE_MAP_POSITIVE_X&&l<=e.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&e.framebufferTexture2D(e.FRAMEBUFFER,c,l,h.__webglTexture,u),n.bindFramebuffer(e.FRAMEBUFFER,null)}function Se(t,n,r){if(e.bindRenderbuffer(e.RENDERBUFFER,t),n.depthBuffer){let i=n.depthTexture,a=i&&i.isDepthTexture?i.type:null,o=C(n.stencilBuffer,a),c=n.stencilBuffer?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT;U(n)?s.renderbufferStorageMultisampleEXT(e.RENDERBUFFER,ke(n),o,n.width,n.height):r?e.renderbufferStorageMultisample(e.RENDERBUFFER,ke(n),o,n.width,n.height):e.renderbufferStorage(e.RENDERBUFFER,o,n.width,n.height),e.framebufferRenderbuffer(e.FRAMEBUFFER,c,e.RENDERBUFFER,t)}else{let t=n.textures;for(let i=0;i<t.length;i++){let o=t[i],c=a.convert(o.format,o.colorSpace),l=a.convert(o.type),u=S(o.internalFormat,c,l,o.normalized,o.colorSpace);U(n)?s.renderbufferStorageMultisampleEXT(e.RENDERBUFFER,ke(n),u,n.width,n.height):r?e.renderbufferStorageMultisample(e.RENDERBUFFER,ke(n),u,n.width,n.height):e.renderbufferStorage(e.RENDERBUFFER,u,n.width,n.height)}}e.bindRenderbuffer(e.RENDERBUFFER,null)}function Ce(t,i,a){let o=i.isWebGLCubeRenderTarget===!0;if(n.bindFramebuffer(e.FRAMEBUFFER,t),!(i.depthTexture&&i.depthTexture.isDepthTexture))throw Error(`THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.`);let c=r.get(i.depthTexture);c.__renderTarget=i;let l=o?i.depthTexture.image[0]:i.depthTexture.image;c.__webglTexture&&l.width===i.width&&l.height===i.height||(l.width=i.width,l.height=i.height,i.depthTexture.needsUpdate=!0),o?oe(i.depthTexture,0):F(i.depthTexture,0);let u=c.__webglTexture,d=ke(i),f=o?e.TEXTURE_CUBE_MAP_POSITIVE_X+a:e.TEXTURE_2D,p=i.depthTexture.format===1027?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT;if(i.depthTexture.format===1026)U(i)?s.framebufferTexture2DMultisampleEXT(e.FRAMEBUFFER,p,f,u,0,d):e.framebufferTexture2D(e.FRAMEBUFFER,p,f,u,0);else if(i.depthTexture.format===1027)U(i)?s.framebufferTexture2DMultisampleEXT(e.FRAMEBUFFER,p,f,u,0,d):e.framebufferTexture2D(e.FRAMEBUFFER,p,f,u,0);else throw Error(`THREE.WebGLTextures: Unknown depthTexture format.`)}function H(t){let i=r.get(t),a=t.isWebGLCubeRenderTarget===!0;if(i.__boundDepthTexture!==t.depthTexture){let e=t.depthTexture;if(i.__depthDisposeCallback&&i.__depthDisposeCallback(),e){let t=()=>{delete i.__boundDepthTexture,delete i.__depthDisposeCallback,e.removeEventListener(`dispose`,t)};e.addEventListener(`dispose`,t),i.__depthDisposeCallback=t}i.__boundDepthTexture=e}if(t.depthTexture&&!i.__autoAllocateDepthBuffer){if(a)for(let e=0;e<6;e++)Ce(i.__webglFramebuffer[e],t,e);else t.texture.mipmaps.length>0?Ce(i.__webglFramebuffer[0],t,0):Ce(i.__webglFramebuffer,t,0)}else if(a){i.__webglDepthbuffer=[];for(let r=0;r<6;r++)if(n.bindFramebuffer(e.FRAMEBUFFER,i.__webglFramebuffer[r]),i.__webglDepthbuffer[r]===void 0)i.__webglDepthbuffer[r]=e.createRenderbuffer(),Se(i.__webglDepthbuffer[r],t,!1);else{let n=t.stencilBuffer?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT,a=i.__webglDepthbuffer[r];e.bindRenderbuffer(e.RENDERBUFFER,a),e.framebufferRenderbuffer(e.FRAMEBUFFER,n,e.RENDERBUFFER,a)}}else if(t.texture.mipmaps.length>0?n.bindFramebuffer(e.FRAMEBUFFER,i.__webglFramebuffer[0]):n.bindFramebuffer(e.FRAMEBUFFER,i.__webglFramebuffer),i.__webglDepthbuffer===void 0)i.__webglDepthbuffer=e.createRenderbuffer(),Se(i.__webglDepthbuffer,t,!1);else{let n=t.stencilBuffer?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT,r=i.__webglDepthbuffer;e.bindRenderbuffer(e.RENDERBUFFER,r),e.framebufferRenderbuffer(e.FRAMEBUFFER,n,e.RENDERBUFFER,r)}n.bindFramebuffer(e.FRAMEBUFFER,null)}function we(t,n,i){let a=r.get(t);n!==void 0&&V(a.__webglFramebuffer,t,t.texture,e.COLOR_ATTACHMENT0,e.TEXTURE_2D,0),i!==void 0&&H(t)}function Te(t){let i=t.texture,s=r.get(t),c=r.get(i);t.addEventListener(`dispose`,O),T(t);let l=t.textures,u=t.isWebGLCubeRenderTarget===!0,d=l.length>1;if(d||(c.__webglTexture===void 0&&(c.__webglTexture=e.createTexture()),c.__version=i.version,o.memory.textures++),u){s.__webglFramebuffer=[];for(let t=0;t<6;t++)if(i.mipmaps.length>0){s.__webglFramebuffer[t]=[];for(let n=0;n<i.mipmaps.length;n++)s.__webglFramebuffer[t][n]=e.createFramebuffer()}else s.__webglFramebuffer[t]=e.createFramebuffer()}else{if(i.mipmaps.length>0){s.__webglFramebuffer=[];for(let t=0;t<i.mipmaps.length;t++)s.__webglFramebuffer[t]=e.createFramebuffer()}else s.__webglFramebuffer=e.createFramebuffer();if(d)for(let t=0,n=l.length;t<n;t++){let n=r.get(l[t]);n.__webglTexture===void 0&&(n.__webglTexture=e.createTexture(),o.memory.textures++)}if(t.samples>0&&U(t)===!1){s.__webglMultisampledFramebuffer=e.createFramebuffer(),s.__webglColorRenderbuffer=[],n.bindFramebuffer(e.FRAMEBUFFER,s.__webglMultisampledFramebuffer);for(let n=0;n<l.length;n++){let r=l[n];s.__webglColorRenderbuffer[n]=e.createRenderbuffer(),e.bindRenderbuffer(e.RENDERBUFFER,s.__webglColorRenderbuffer[n]);let i=a.convert(r.format,r.colorSpace),o=a.convert(r.type),c=S(r.internalFormat,i,o,r.normalized,r.colorSpace,t.isXRRenderTarget===!0),u=ke(t);e.renderbufferStorageMultisample(e.RENDERBUFFER,u,c,t.width,t.height),e.framebufferRenderbuffer(e.FRAMEBUFFER,e.COLOR_ATTACHMENT0+n,e.RENDERBUFFER,s.__webglColorRenderbuffer[n])}e.bindRenderbuffer(e.RENDERBUFFER,null),t.depthBuffer&&(s.__webglDepthRenderbuffer=e.createRenderbuffer(),Se(s.__webglDepthRenderbuffer,t,!0)),n.bindFramebuffer(e.FRAMEBUFFER,null)}}if(u){n.bindTexture(e.TEXTURE_CUBE_MAP,c.__webglTexture),ue(e.TEXTURE_CUBE_MAP,i);for(let n=0;n<6;n++)if(i.mipmaps.length>0)for(let r=0;r<i.mipmaps.length;r++)V(s.__webglFramebuffer[n][r],t,i,e.COLOR_ATTACHMENT0,e.TEXTURE_CUBE_MAP_POSITIVE_X+n,r);else V(s.__webglFramebuffer[n],t,i,e.COLOR_ATTACHMENT0,e.TEXTURE_CUBE_MAP_POSITIVE_X+n,0);y(i)?b(e.TEXTURE_CUBE_MAP):i.mipmaps.length>0&&e.texParameteri(e.TEXTURE_CUBE_MAP,e.TEXTURE_MAX_LEVEL,i.mipmaps.length-1),n.unbindTexture()}else if(d){for(let i=0,a=l.length;i<a;i++){let a=l[i],o=r.get(a),c=e.TEXTURE_2D;(t.isWebGL3DRenderTarget||t.isWebGLArrayRenderTarget)&&(c=t.isWebGL3DRenderTarget?e.TEXTURE_3D:e.TEXTURE_2D_ARRAY),n.bindTexture(c,o.__webglTexture),ue(c,a),V(s.__webglFramebuffer,t,a,e.COLOR_ATTACHMENT0+i,c,0),y(a)&&b(c)}n.unbindTexture()}else{let r=e.TEXTURE_2D;if((t.isWebGL3DRenderTarget||t.isWebGLArrayRenderTarget)&&(r=t.isWebGL3DRenderTarget?e.TEXTURE_3D:e.TEXTURE_2D_ARRAY),n.bindTexture(r,c.__webglTexture),ue(r,i),i.mipmaps.length>0)for(let n=0;n<i.mipmaps.length;n++)V(s.__webglFramebuffer[n],t,i,e.COLOR_ATTACHMENT0,r,n);else V(s.__webglFramebuffer,t,i,e.COLOR_ATTACHMENT0,r,0);y(i)?b(r):i.mipmaps.length>0&&e.texParameteri(r,e.TEXTURE_MAX_LEVEL,i.mipmaps.length-1),n.unbindTexture()}t.depthBuffer&&H(t)}function Ee(e){let t=e.textures;for(let i=0,a=t.length;i<a;i++){let a=t[i];if(y(a)&&a.mipmapsAutoUpdate===!0){let t=x(e),i=r.get(a).__webglTexture;n.bindTexture(t,i),b(t),n.unbindTexture()}}}let De=[];function Oe(t){if(t.samples>0){if(U(t)===!1){let i=t.textures,a=t.width,o=t.height,s=e.COLOR_BUFFER_BIT,l=t.stencilBuffer?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT,u=r.get(t),d=i.length>1;if(d)for(let t=0;t<i.length;t++)n.bindFramebuffer(e.FRAMEBUFFER,u.__webglMultisampledFramebuffer),e.framebufferRenderbuffer(e.FRAMEBUFFER,e.COLOR_ATTACHMENT0+t,e.RENDERBUFFER,null),n.bindFramebuffer(e.FRAMEBUFFER,u.__webglFramebuffer),e.framebufferTexture2D(e.DRAW_FRAMEBUFFER,e.COLOR_ATTACHMENT0+t,e.TEXTURE_2D,null,0);n.bindFramebuffer(e.READ_FRAMEBUFFER,u.__webglMultisampledFramebuffer),t.texture.mipmaps.length>0?n.bindFramebuffer(e.DRAW_FRAMEBUFFER,u.__webglFramebuffer[0]):n.bindFramebuffer(e.DRAW_FRAMEBUFFER,u.__webglFramebuffer);for(let n=0;n<i.length;n++){if(t.resolveDepthBuffer&&(t.depthBuffer&&(s|=e.DEPTH_BUFFER_BIT),t.stencilBuffer&&t.resolveStencilBuffer&&(s|=e.STENCIL_BUFFER_BIT)),d){e.framebufferRenderbuffer(e.READ_FRAMEBUFFER,e.COLOR_ATTACHMENT0,e.RENDERBUFFER,u.__webglColorRenderbuffer[n]);let t=r.get(i[n]).__webglTexture;e.framebufferTexture2D(e.DRAW_FRAMEBUFFER,e.COLOR_ATTACHMENT0,e.TEXTURE_2D,t,0)}e.blitFramebuffer(0,0,a,o,0,0,a,o,s,e.NEAREST),c===!0&&(De.length=0,De.push(e.COLOR_ATTACHMENT0+n),t.depthBuffer&&t.storeMultisampledDepthBuffer===!1&&De.push(l),e.invalidateFramebuffer(e.READ_FRAMEBUFFER,De))}if(n.bindFramebuffer(e.READ_FRAMEBUFFER,null),n.bindFramebuffer(e.DRAW_FRAMEBUFFER,null),d)for(let t=0;t<i.length;t++){n.bindFramebuffer(e.FRAMEBUFFER,u.__webglMultisampledFramebuffer),e.framebufferRenderbuffer(e.FRAMEBUFFER,e.COLOR_ATTACHMENT0+t,e.RENDERBUFFER,u.__webglColorRenderbuffer[t]);let a=r.get(i[t]).__webglTexture;n.bindFramebuffer(e.FRAMEBUFFER,u.__webglFramebuffer),e.framebufferTexture2D(e.DRAW_FRAMEBUFFER,e.COLOR_ATTACHMENT0+t,e.TEXTURE_2D,a,0)}n.bindFramebuffer(e.DRAW_FRAMEBUFFER,u.__webglMultisampledFramebuffer)}else if(t.depthBuffer&&t.storeMultisampledDepthBuffer===!1&&c){let n=t.stencilBuffer?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT;e.invalidateFramebuffer(e.DRAW_FRAMEBUFFER,[n])}}}function ke(e){return Math.min(i.maxSamples,e.samples)}function U(e){let n=r.get(e);return e.samples>0&&t.has(`WEBGL_multisampled_render_to_texture`)===!0&&n.__useRenderToTexture!==!1}function W(e){let t=o.render.frame;u.get(e)!==t&&(u.set(e,t),e.update())}function Ae(e,t){let n=e.colorSpace,r=e.format,i=e.type;return e.isCompressedTexture===!0||e.isVideoTexture===!0||n!==`srgb-linear`&&n!==``&&(jn.getTransfer(n)===`srgb`?(r!==1023||i!==1009)&&G(`WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType.`):K(`WebGLTextures: Unsupported texture color space:`,n)),t}function je(e){return typeof HTMLImageElement<`u`&&e instanceof HTMLImageElement?(l.width=e.naturalWidth||e.width,l.height=e.naturalHeight||e.height):typeof VideoFrame<`u`&&e instanceof VideoFrame?(l.width=e.displayWidth,l.height=e.displayHeight):(l.width=e.width,l.height=e.height),l}this.allocateTextureUnit=P,this.resetTextureUnits=ne,this.getTextureUnits=re,this.setTextureUnits=ie,this.setTexture2D=F,this.setTexture2DArray=I,this.setTexture3D=L,this.setTextureCube=oe,this.rebindTextures=we,this.setupRenderTarget=Te,this.updateRenderTargetMipmap=Ee,this.updateMultisampleRenderTarget=Oe,this.setupDepthRenderbuffer=H,this.setupFrameBufferTexture=V,this.useMultisampledRTT=U,this.dispose=j}function kl(e,t){function n(n,r=``){let i,a=jn.getTransfer(r);if(n===1009)return e.UNSIGNED_BYTE;if(n===1017)return e.UNSIGNED_SHORT_4_4_4_4;if(n===1018)return e.UNSIGNED_SHORT_5_5_5_1;if(n===35902)return e.UNSIGNED_INT_5_9_9_9_REV;if(n===35899)return e.UNSIGNED_INT_10F_11F_11F_REV;if(n===1010)return e.BYTE;if(n===1011)return e.SHORT;if(n===1012)return e.UNSIGNED_SHORT;if(n===1013)return e.INT;if(n===1014)return e.UNSIGNED_INT;if(n===1015)return e.FLOAT;if(n===1016)return e.HALF_FLOAT;if(n===1021)return e.ALPHA;if(n===1022)return e.RGB;if(n===1023)return e.RGBA;if(n===1026)return e.DEPTH_COMPONENT;if(n===1027)return e.DEPTH_STENCIL;if(n===1028)return e.RED;if(n===1029)return e.RED_INTEGER;if(n===1030)return e.RG;if(n===1031)return e.RG_INTEGER;if(n===1033)return e.RGBA_INTEGER;if(n===33776||n===33777||n===33778||n===33779){if(a===`srgb`){if(i=t.get(`WEBGL_compressed_texture_s3tc_srgb`),i!==null){if(n===33776)return i.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===33777)return i.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===33778)return i.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===33779)return i.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null}else if(i=t.get(`WEBGL_compressed_texture_s3tc`),i!==null){if(n===33776)return i.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===33777)return i.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===33778)return i.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===33779)return i.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null}if(n===35840||n===35841||n===35842||n===35843){if(i=t.get(`WEBGL_compressed_texture_pvrtc`),i!==null){if(n===35840)return i.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===35841)return i.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===35842)return i.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===35843)return i.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null}if(n===36196||n===37492||n===37496||n===37488||n===37489||n===37490||n===37491){if(i=t.get(`WEBGL_compressed_texture_etc`),i!==null){if(n===36196||n===37492)return a===`srgb`?i.COMPRESSED_SRGB8_ETC2:i.COMPRESSED_RGB8_ETC2;if(n===37496)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:i.COMPRESSED_RGBA8_ETC2_EAC;if(n===37488)return i.COMPRESSED_R11_EAC;if(n===37489)return i.COMPRESSED_SIGNED_R11_EAC;if(n===37490)return i.COMPRESSED_RG11_EAC;if(n===37491)return i.COMPRESSED_SIGNED_RG11_EAC}else return null}if(n===37808||n===37809||n===37810||n===37811||n===37812||n===37813||n===37814||n===37815||n===37816||n===37817||n===37818||n===37819||n===37820||n===37821){if(i=t.get(`WEBGL_compressed_texture_astc`),i!==null){if(n===37808)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:i.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===37809)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:i.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===37810)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:i.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===37811)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:i.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===37812)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:i.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===37813)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:i.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===37814)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:i.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===37815)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:i.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===37816)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:i.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===37817)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:i.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===37818)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:i.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===37819)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:i.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===37820)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:i.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===37821)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:i.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null}if(n===36492||n===36494||n===36495){if(i=t.get(`EXT_texture_compression_bptc`),i!==null){if(n===36492)return a===`srgb`?i.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:i.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===36494)return i.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===36495)return i.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null}if(n===36283||n===36284||n===36285||n===36286){if(i=t.get(`EXT_texture_compression_rgtc`),i!==null){if(n===36283)return i.COMPRESSED_RED_RGTC1_EXT;if(n===36284)return i.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===36285)return i.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===36286)return i.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null}return n===1020?e.UNSIGNED_INT_24_8:e[n]===void 0?null:e[n]}return{convert:n}}var Al=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,jl=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Ml=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new ba(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new ja({vertexShader:Al,fragmentShader:jl,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Ji(new Sa(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Nl=class extends Jt{constructor(e,t){super();let n=this,r=null,i=1,a=null,o=`local-floor`,s=1,c=null,l=null,u=null,d=null,f=null,p=null,m=typeof XRWebGLBinding<`u`,h=new Ml,g={},_=t.getContextAttributes(),v=null,y=null,b=[],x=[],S=new q,C=null,w=null,T=new co;T.viewport=new Hn;let E=new co;E.viewport=new Hn;let D=[T,E],O=new mo,k=null,A=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(e){let t=b[e];return t===void 0&&(t=new Cr,b[e]=t),t.getTargetRaySpace()},this.getControllerGrip=function(e){let t=b[e];return t===void 0&&(t=new Cr,b[e]=t),t.getGripSpace()},this.getHand=function(e){let t=b[e];return t===void 0&&(t=new Cr,b[e]=t),t.getHandSpace()};function j(e){let t=x.indexOf(e.inputSource);if(t===-1)return;let n=b[t];n!==void 0&&(n.update(e.inputSource,e.frame,c||a),n.dispatchEvent({type:e.type,data:e.inputSource}))}function M(){r.removeEventListener(`select`,j),r.removeEventListener(`selectstart`,j),r.removeEventListener(`selectend`,j),r.removeEventListener(`squeeze`,j),r.removeEventListener(`squeezestart`,j),r.removeEventListener(`squeezeend`,j),r.removeEventListener(`end`,M),r.removeEventListener(`inputsourceschange`,N);for(let e=0;e<b.length;e++){let t=x[e];t!==null&&(x[e]=null,b[e].disconnect(t))}k=null,A=null,h.reset();for(let e in g)delete g[e];if(e.setRenderTarget(v),f=null,d=null,u=null,r=null,y=null,ie.stop(),n.isPresenting=!1,e.setPixelRatio(C),e.setSize(S.width,S.height,!1),w!==null){let e=w.camera;e.fov=w.fov,e.zoom=w.zoom,e.updateProjectionMatrix(),w=null}n.dispatchEvent({type:`sessionend`})}this.setFramebufferScaleFactor=function(e){i=e,n.isPresenting===!0&&G(`WebXRManager: Cannot change framebuffer scale while presenting.`)},this.setReferenceSpaceType=function(e){o=e,n.isPresenting===!0&&G(`WebXRManager: Cannot change reference space type while presenting.`)},this.getReferenceSpace=function(){return c||a},this.setReferenceSpace=function(e){c=e},this.getBaseLayer=function(){return d===null?f:d},this.getBinding=function(){return u===null&&m&&(u=new XRWebGLBinding(r,t)),u},this.getFrame=function(){return p},this.getSession=function(){return r},this.setSession=async function(l){if(r=l,r!==null){if(v=e.getRenderTarget(),r.addEventListener(`select`,j),r.addEventListener(`selectstart`,j),r.addEventListener(`selectend`,j),r.addEventListener(`squeeze`,j),r.addEventListener(`squeezestart`,j),r.addEventListener(`squeezeend`,j),r.addEventListener(`end`,M),r.addEventListener(`inputsourceschange`,N),_.xrCompatible!==!0&&await t.makeXRCompatible(),C=e.getPixelRatio(),e.getSize(S),m&&`createProjectionLayer`in XRWebGLBinding.prototype){let n=null,a=null,o=null;_.depth&&(o=_.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,n=_.stencil?Pe:Ne,a=_.stencil?ke:we);let s={colorFormat:t.RGBA8,depthFormat:o,scaleFactor:i};u=this.getBinding(),d=u.createProjectionLayer(s),r.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),y=new Wn(d.textureWidth,d.textureHeight,{format:Me,type:xe,depthTexture:new va(d.textureWidth,d.textureHeight,a,void 0,void 0,void 0,void 0,void 0,void 0,n),stencilBuffer:_.stencil,colorSpace:e.outputColorSpace,samples:_.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let n={antialias:_.antialias,alpha:!0,depth:_.depth,stencil:_.stencil,framebufferScaleFactor:i};f=new XRWebGLLayer(r,t,n),r.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),y=new Wn(f.framebufferWidth,f.framebufferHeight,{format:Me,type:xe,colorSpace:e.outputColorSpace,stencilBuffer:_.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}y.isXRRenderTarget=!0,this.setFoveation(s),c=null,a=await r.requestReferenceSpace(o),ie.setContext(r),ie.start(),n.isPresenting=!0,n.dispatchEvent({type:`sessionstart`})}},this.getEnvironmentBlendMode=function(){if(r!==null)return r.environmentBlendMode},this.getDepthTexture=function(){return h.getDepthTexture()};function N(e){for(let t=0;t<e.removed.length;t++){let n=e.removed[t],r=x.indexOf(n);r>=0&&(x[r]=null,b[r].disconnect(n))}for(let t=0;t<e.added.length;t++){let n=e.added[t],r=x.indexOf(n);if(r===-1){for(let e=0;e<b.length;e++)if(e>=x.length){x.push(n),r=e;break}else if(x[e]===null){x[e]=n,r=e;break}if(r===-1)break}let i=b[r];i&&i.connect(n)}}function ee(e,t){t===null?e.matrixWorld.copy(e.matrix):e.matrixWorld.multiplyMatrices(t.matrixWorld,e.matrix),e.matrixWorldInverse.copy(e.matrixWorld).invert()}this.updateCamera=function(e){if(r===null)return;let t=e.near,n=e.far;h.texture!==null&&(h.depthNear>0&&(t=h.depthNear),h.depthFar>0&&(n=h.depthFar)),O.near=E.near=T.near=t,O.far=E.far=T.far=n,(k!==O.near||A!==O.far)&&(r.updateRenderState({depthNear:O.near,depthFar:O.far}),k=O.near,A=O.far),O.layers.mask=e.layers.mask|6,T.layers.mask=O.layers.mask&-5,E.layers.mask=O.layers.mask&-3;let i=e.parent,a=O.cameras;ee(O,i);for(let e=0;e<a.length;e++)ee(a[e],i);O.projectionMatrix.copy(T.projectionMatrix),O.projectionMatrixInverse.copy(T.projectionMatrixInverse),w===null&&e.isPerspectiveCamera&&(w={camera:e,fov:e.fov,zoom:e.zoom}),te(e,O,i)};function te(e,t,n){n===null?e.matrix.copy(t.matrixWorld):(e.matrix.copy(n.matrixWorld),e.matrix.invert(),e.matrix.multiply(t.matrixWorld)),e.matrix.decompose(e.position,e.quaternion,e.scale),e.updateMatrixWorld(!0),e.projectionMatrix.copy(t.projectionMatrix),e.projectionMatrixInverse.copy(t.projectionMatrixInverse),e.isPerspectiveCamera&&(e.fov=Qt*2*Math.atan(1/e.projectionMatrix.elements[5]),e.zoom=1)}this.getCamera=function(){return O},this.getFoveation=function(){if(d!==null||f!==null)return s},this.setFoveation=function(e){s=e,d!==null&&(d.fixedFoveation=e),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=e)},this.hasDepthSensing=function(){return h.texture!==null},this.getDepthSensingMesh=function(){return h.getMesh(O)},this.getCameraTexture=function(e){return g[e]};let ne=null;function re(t,i){if(l=i.getViewerPose(c||a),p=i,l!==null){let t=l.views;f!==null&&(e.setRenderTargetFramebuffer(y,f.framebuffer),e.setRenderTarget(y));let i=!1;t.length!==O.cameras.length&&(O.cameras.length=0,i=!0);for(let n=0;n<t.length;n++){let r=t[n],a=null;if(f!==null)a=f.getViewport(r);else{let t=u.getViewSubImage(d,r);a=t.viewport,n===0&&(e.setRenderTargetTextures(y,t.colorTexture,t.depthStencilTexture),e.setRenderTarget(y))}let o=D[n];o===void 0&&(o=new co,o.layers.enable(n),o.viewport=new Hn,D[n]=o),o.matrix.fromArray(r.transform.matrix),o.matrix.decompose(o.position,o.quaternion,o.scale),o.projectionMatrix.fromArray(r.projectionMatrix),o.projectionMatrixInverse.copy(o.projectionMatrix).invert(),o.viewport.set(a.x,a.y,a.width,a.height),n===0&&(O.matrix.copy(o.matrix),O.matrix.decompose(O.position,O.quaternion,O.scale)),i===!0&&O.cameras.push(o)}let a=r.enabledFeatures;if(a&&a.includes(`depth-sensing`)&&r.depthUsage==`gpu-optimized`&&m){u=n.getBinding();let e=u.getDepthInformation(t[0]);e&&e.isValid&&e.texture&&h.init(e,r.renderState)}if(a&&a.includes(`camera-access`)&&m){e.state.unbindTexture(),u=n.getBinding();for(let e=0;e<t.length;e++){let n=t[e].camera;if(n){let e=g[n];e||(e=new ba,g[n]=e);let t=u.getCameraImage(n);e.sourceTexture=t}}}}for(let e=0;e<b.length;e++){let t=x[e],n=b[e];t!==null&&n!==void 0&&n.update(t,i,c||a)}ne&&ne(t,i),i.detectedPlanes&&n.dispatchEvent({type:`planesdetected`,data:i}),p=null}let ie=new jo;ie.setAnimationLoop(re),this.setAnimationLoop=function(e){ne=e},this.dispose=function(){}}},Pl=new qn,Fl=new Y;Fl.set(-1,0,0,0,1,0,0,0,1);function Il(e,t){function n(e,t){e.matrixAutoUpdate===!0&&e.updateMatrix(),t.value.copy(e.matrix)}function r(t,n){n.color.getRGB(t.fogColor.value,Da(e)),n.isFog?(t.fogNear.value=n.near,t.fogFar.value=n.far):n.isFogExp2&&(t.fogDensity.value=n.density)}function i(e,t,n,r,i){t.isNodeMaterial?t.uniformsNeedUpdate=!1:t.isMeshBasicMaterial?a(e,t):t.isMeshLambertMaterial?(a(e,t),t.envMap&&(e.envMapIntensity.value=t.envMapIntensity)):t.isMeshToonMaterial?(a(e,t),d(e,t)):t.isMeshPhongMaterial?(a(e,t),u(e,t),t.envMap&&(e.envMapIntensity.value=t.envMapIntensity)):t.isMeshStandardMaterial?(a(e,t),f(e,t),t.isMeshPhysicalMaterial&&p(e,t,i)):t.isMeshMatcapMaterial?(a(e,t),m(e,t)):t.isMeshDepthMaterial?a(e,t):t.isMeshDistanceMaterial?(a(e,t),h(e,t)):t.isMeshNormalMaterial?a(e,t):t.isLineBasicMaterial?(o(e,t),t.isLineDashedMaterial&&s(e,t)):t.isPointsMaterial?c(e,t,n,r):t.isSpriteMaterial?l(e,t):t.isShadowMaterial?(e.color.value.copy(t.color),e.opacity.value=t.opacity):t.isShaderMaterial&&(t.uniformsNeedUpdate=!1)}function a(e,r){e.opacity.value=r.opacity,r.color&&e.diffuse.value.copy(r.color),r.emissive&&e.emissive.value.copy(r.emissive).multiplyScalar(r.emissiveIntensity),r.map&&(e.map.value=r.map,n(r.map,e.mapTransform)),r.alphaMap&&(e.alphaMap.value=r.alphaMap,n(r.alphaMap,e.alphaMapTransform)),r.bumpMap&&(e.bumpMap.value=r.bumpMap,n(r.bumpMap,e.bumpMapTransform),e.bumpScale.value=r.bumpScale,r.side===1&&(e.bumpScale.value*=-1)),r.normalMap&&(e.normalMap.value=r.normalMap,n(r.normalMap,e.normalMapTransform),e.normalScale.value.copy(r.normalScale),r.side===1&&e.normalScale.value.negate()),r.displacementMap&&(e.displacementMap.value=r.displacementMap,n(r.displacementMap,e.displacementMapTransform),e.displacementScale.value=r.displacementScale,e.displacementBias.value=r.displacementBias),r.emissiveMap&&(e.emissiveMap.value=r.emissiveMap,n(r.emissiveMap,e.emissiveMapTransform)),r.specularMap&&(e.specularMap.value=r.specularMap,n(r.specularMap,e.specularMapTransform)),r.alphaTest>0&&(e.alphaTest.value=r.alphaTest);let i=t.get(r),a=i.envMap,o=i.envMapRotation;a&&(e.envMap.value=a,e.envMapRotation.value.setFromMatrix4(Pl.makeRotationFromEuler(o)).transpose(),a.isCubeTexture&&a.isRenderTargetTexture===!1&&e.envMapRotation.value.premultiply(Fl),e.reflectivity.value=r.reflectivity,e.ior.value=r.ior,e.refractionRatio.value=r.refractionRatio),r.lightMap&&(e.lightMap.value=r.lightMap,e.lightMapIntensity.value=r.lightMapIntensity,n(r.lightMap,e.lightMapTransform)),r.aoMap&&(e.aoMap.value=r.aoMap,e.aoMapIntensity.value=r.aoMapIntensity,n(r.aoMap,e.aoMapTransform))}function o(e,t){e.diffuse.value.copy(t.color),e.opacity.value=t.opacity,t.map&&(e.map.value=t.map,n(t.map,e.mapTransform))}function s(e,t){e.dashSize.value=t.dashSize,e.totalSize.value=t.dashSize+t.gapSize,e.scale.value=t.scale}function c(e,t,r,i){e.diffuse.value.copy(t.color),e.opacity.value=t.opacity,e.size.value=t.size*r,e.scale.value=i*.5,t.map&&(e.map.value=t.map,n(t.map,e.uvTransform)),t.alphaMap&&(e.alphaMap.value=t.alphaMap,n(t.alphaMap,e.alphaMapTransform)),t.alphaTest>0&&(e.alphaTest.value=t.alphaTest)}function l(e,t){e.diffuse.value.copy(t.color),e.opacity.value=t.opacity,e.rotation.value=t.rotation,t.map&&(e.map.value=t.map,n(t.map,e.mapTransform)),t.alphaMap&&(e.alphaMap.value=t.alphaMap,n(t.alphaMap,e.alphaMapTransform)),t.alphaTest>0&&(e.alphaTest.value=t.alphaTest)}function u(e,t){e.specular.value.copy(t.specular),e.shininess.value=Math.max(t.shininess,1e-4)}function d(e,t){t.gradientMap&&(e.gradientMap.value=t.gradientMap)}function f(e,t){e.metalness.value=t.metalness,t.metalnessMap&&(e.metalnessMap.value=t.metalnessMap,n(t.metalnessMap,e.metalnessMapTransform)),e.roughness.value=t.roughness,t.roughnessMap&&(e.roughnessMap.value=t.roughnessMap,n(t.roughnessMap,e.roughnessMapTransform)),t.envMap&&(e.envMapIntensity.value=t.envMapIntensity)}function p(e,t,r){e.ior.value=t.ior,t.diffuseRoughness>0&&(e.diffuseRoughness.value=t.diffuseRoughness,t.diffuseRoughnessMap&&(e.diffuseRoughnessMap.value=t.diffuseRoughnessMap,n(t.diffuseRoughnessMap,e.diffuseRoughnessMapTransform))),t.sheen>0&&(e.sheenColor.value.copy(t.sheenColor).multiplyScalar(t.sheen),e.sheenRoughness.value=t.sheenRoughness,t.sheenColorMap&&(e.sheenColorMap.value=t.sheenColorMap,n(t.sheenColorMap,e.sheenColorMapTransform)),t.sheenRoughnessMap&&(e.sheenRoughnessMap.value=t.sheenRoughnessMap,n(t.sheenRoughnessMap,e.sheenRoughnessMapTransform))),t.clearcoat>0&&(e.clearcoat.value=t.clearcoat,e.clearcoatRoughness.value=t.clearcoatRoughness,t.clearcoatMap&&(e.clearcoatMap.value=t.clearcoatMap,n(t.clearcoatMap,e.clearcoatMapTransform)),t.clearcoatRoughnessMap&&(e.clearcoatRoughnessMap.value=t.clearcoatRoughnessMap,n(t.clearcoatRoughnessMap,e.clearcoatRoughnessMapTransform)),t.clearcoatNormalMap&&(e.clearcoatNormalMap.value=t.clearcoatNormalMap,n(t.clearcoatNormalMap,e.clearcoatNormalMapTransform),e.clearcoatNormalScale.value.copy(t.clearcoatNormalScale),t.side===1&&e.clearcoatNormalScale.value.negate())),t.dispersion>0&&(e.dispersion.value=t.dispersion),t.retroreflectivity>0&&(e.retroreflectivity.value=t.retroreflectivity),t.iridescence>0&&(e.iridescence.value=t.iridescence,e.iridescenceIOR.value=t.iridescenceIOR,e.iridescenceThicknessMinimum.value=t.iridescenceThicknessMinimum,e.iridescenceThicknessMaximum.value=t.iridescenceThicknessMaximum,t.iridescenceMap&&(e.iridescenceMap.value=t.iridescenceMap,n(t.iridescenceMap,e.iridescenceMapTransform)),t.iridescenceThicknessMap&&(e.iridescenceThicknessMap.value=t.iridescenceThicknessMap,n(t.iridescenceThicknessMap,e.iridescenceThicknessMapTransform))),t.transmission>0&&(e.transmission.value=t.transmission,e.transmissionSamplerMap.value=r.texture,e.transmissionSamplerSize.value.set(r.width,r.height),t.transmissionMap&&(e.transmissionMap.value=t.transmissionMap,n(t.transmissionMap,e.transmissionMapTransform)),e.thickness.value=t.thickness,t.thicknessMap&&(e.thicknessMap.value=t.thicknessMap,n(t.thicknessMap,e.thicknessMapTransform)),e.attenuationDistance.value=t.attenuationDistance,e.attenuationColor.value.copy(t.attenuationColor)),t.anisotropy>0&&(e.anisotropyVector.value.set(t.anisotropy*Math.cos(t.anisotropyRotation),t.anisotropy*Math.sin(t.anisotropyRotation)),t.anisotropyMap&&(e.anisotropyMap.value=t.anisotropyMap,n(t.anisotropyMap,e.anisotropyMapTransform))),e.specularIntensity.value=t.specularIntensity,e.specularColor.value.copy(t.specularColor),t.specularColorMap&&(e.specularColorMap.value=t.specularColorMap,n(t.specularColorMap,e.specularColorMapTransform)),t.specularIntensityMap&&(e.specularIntensityMap.value=t.specularIntensityMap,n(t.specularIntensityMap,e.specularIntensityMapTransform))}function m(e,t){t.matcap&&(e.matcap.value=t.matcap)}function h(e,n){let r=t.get(n).light;e.referencePosition.value.setFromMatrixPosition(r.matrixWorld),e.nearDistance.value=r.shadow.camera.near,e.farDistance.value=r.shadow.camera.far}return{refreshFogUniforms:r,refreshMaterialUniforms:i}}function Ll(e,t,n,r){let i={},a={};function o(e,t){let n=t.program;r.uniformBlockBinding(e,n,i[e.id])}function s(e,n){let o=i[e.id];o===void 0&&(m(e),o=c(e),i[e.id]=o,e.addEventListener(`dispose`,g));let s=n.program;r.updateUBOMapping(e,s);let u=t.render.frame;a[e.id]!==u&&(l(e),a[e.id]=u)}function c(t){let n=e.createBuffer(),r=t.__size,i=t.usage;return e.bindBuffer(e.UNIFORM_BUFFER,n),e.bufferData(e.UNIFORM_BUFFER,r,i),e.bindBuffer(e.UNIFORM_BUFFER,null),n}function l(t){let n=i[t.id],r=t.uniforms,a=t.__cache;e.bindBuffer(e.UNIFORM_BUFFER,n);for(let e=0,t=r.length;e<t;e++){let t=r[e];if(Array.isArray(t))for(let n=0,r=t.length;n<r;n++)u(t[n],e,n,a);else u(t,e,0,a)}e.bindBuffer(e.UNIFORM_BUFFER,null)}function u(t,n,r,i){if(f(t,n,r,i)===!0){let n=t.__offset,r=t.value;if(Array.isArray(r)){let e=0;for(let n=0;n<r.length;n++){let i=r[n],a=h(i,!0);d(i,t.__data,e),e+=a.storage/Float32Array.BYTES_PER_ELEMENT}}else d(r,t.__data,0);e.bufferSubData(e.UNIFORM_BUFFER,n,t.__data)}}function d(e,t,n){typeof e==`number`||typeof e==`boolean`?t[n]=e:e.isMatrix3?(t[n]=e.elements[0],t[n+1]=e.elements[1],t[n+2]=e.elements[2],t[n+3]=0,t[n+4]=e.elements[3],t[n+5]=e.elements[4],t[n+6]=e.elements[5],t[n+7]=0,t[n+8]=e.elements[6],t[n+9]=e.elements[7],t[n+10]=e.elements[8],t[n+11]=0):ArrayBuffer.isView(e)?t.set(e.subarray(0,t.length-n),n):e.toArray(t,n)}function f(e,t,n,r){let i=e.value,a=t+`_`+n;if(Array.isArray(i)){r[a]===void 0&&(r[a]=[]);let e=r[a],t=!1;for(let n=0;n<i.length;n++)p(i[n],e,n)===!0&&(t=!0);return t}return p(i,r,a)}function p(e,t,n){if(t[n]===void 0)return t[n]=typeof e==`number`||typeof e==`boolean`?e:ArrayBuffer.isView(e)?e.slice():e.clone(),!0;{let r=t[n];if(typeof e==`number`||typeof e==`boolean`){if(r!==e)return t[n]=e,!0}else if(ArrayBuffer.isView(e))return!0;else if(r.equals(e)===!1)return r.copy(e),!0}return!1}function m(e){let t=e.uniforms,n=0;for(let e=0,r=t.length;e<r;e++){let r=Array.isArray(t[e])?t[e]:[t[e]];for(let i=0,a=r.length;i<a;i++){let a=r[i],o=Array.isArray(a.value)?a.value:[a.value],s=Array.isArray(t[e])||Array.isArray(a.value),c=n;for(let e=0,t=o.length;e<t;e++){let t=o[e],r=h(t,s),i=n%16,a=i%r.boundary,l=i+a;n+=a,l!==0&&16-l<r.storage&&(n+=16-l),e===0&&(c=n),n+=r.storage}a.__data=new(a.type===`int`?Int32Array:a.type===`uint`?Uint32Array:Float32Array)((n-c)/Float32Array.BYTES_PER_ELEMENT),a.__offset=c}}let r=n%16;return r>0&&(n+=16-r),e.__size=n,e.__cache={},this}function h(e,t){let n={boundary:0,storage:0};return typeof e==`number`||typeof e==`boolean`?(n.boundary=4,n.storage=4):e.isVector2?(n.boundary=8,n.storage=8):e.isVector3||e.isColor?(n.boundary=16,n.storage=12):e.isVector4?(n.boundary=16,n.storage=16):e.isMatrix3?(n.boundary=16,n.storage=48):e.isMatrix4?(n.boundary=16,n.storage=64):e.isTexture?G(`WebGLRenderer: Texture samplers can not be part of an uniforms group.`):ArrayBuffer.isView(e)?(n.boundary=16,n.storage=e.byteLength):G(`WebGLRenderer: Unsupported uniform value type.`,e),t===!0&&(n.boundary=16,n.storage=Math.ceil(n.storage/16)*16),n}function g(t){let n=t.target;n.removeEventListener(`dispose`,g),e.deleteBuffer(i[n.id]),delete i[n.id],delete a[n.id]}function _(){for(let t in i)e.deleteBuffer(i[t]);i={},a={}}return{bind:o,update:s,dispose:_}}var Rl=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),zl=null;function Bl(){return zl===null&&(zl=new Zi(Rl,16,16,Le,Ee),zl.name=`DFG_LUT`,zl.minFilter=R,zl.magFilter=R,zl.wrapS=ge,zl.wrapT=ge,zl.generateMipmaps=!1,zl.needsUpdate=!0),zl}var Vl=class{constructor(e={}){let{canvas:t=Vt(),context:n=null,depth:r=!0,stencil:i=!1,alpha:a=!1,antialias:o=!1,premultipliedAlpha:s=!0,preserveDrawingBuffer:c=!1,powerPreference:l=`default`,failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=xe}=e;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<`u`&&n instanceof WebGLRenderingContext)throw Error(`THREE.WebGLRenderer: WebGL 1 is not supported since r163.`);p=n.getContextAttributes().alpha}else p=a;let m=f,h=new Set([ze,Re,Ie]),g=new Set([xe,we,Ce,ke,De,Oe]),_=new Uint32Array(4),v=new Int32Array(4),y={textures:[],min:[],max:[],resolution:[]},b=null,x=null,S=[],C=[],w=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=0,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let T=this,E=!1,D=null,O=null,k=null,A=null;this._outputColorSpace=At;let j=0,M=0,N=null,ee=-1,te=null,ne=new Hn,re=new Hn,ie=null,P=new Or(0),ae=0,F=t.width,I=t.height,L=1,oe=null,se=null,ce=new Hn(0,0,F,I),le=new Hn(0,0,F,I),ue=!1,de=new ta,fe=new ra,pe=!1,me=!1,he=new qn,ge=new J,_e=new Hn,ve={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},ye=!1;function be(){return N===null?L:1}let R=n;function z(e,n){return t.getContext(e,n)}let V,Se,H,Te,U,W,Ae,je,Me,Ne,Pe,Fe,Le,Be,Ve,He,Ue,We,Ge,Ke,qe,Je,Ye;try{let e={alpha:!0,depth:r,stencil:i,antialias:o,premultipliedAlpha:s,preserveDrawingBuffer:c,powerPreference:l,failIfMajorPerformanceCaveat:u};if(`setAttribute`in t&&t.setAttribute(`data-engine`,`three.js r187`),t.addEventListener(`webglcontextlost`,Qe,!1),t.addEventListener(`webglcontextrestored`,$e,!1),t.addEventListener(`webglcontextcreationerror`,et,!1),R===null){let t=`webgl2`;if(R=z(t,e),R===null)throw z(t)?Error(`THREE.WebGLRenderer: Error creating WebGL context with your selected attributes.`):Error(`THREE.WebGLRenderer: Error creating WebGL context.`)}Xe()}catch(e){throw t.removeEventListener(`webglcontextlost`,Qe,!1),t.removeEventListener(`webglcontextrestored`,$e,!1),t.removeEventListener(`webglcontextcreationerror`,et,!1),K(`WebGLRenderer: `+e.message),e}function Xe(){V=new ss(R),V.init(),qe=new kl(R,V),Se=new Vo(R,V,e,qe),H=new Dl(R,V),Se.reversedDepthBuffer&&d&&H.buffers.depth.setReversed(!0),O=R.createFramebuffer(),k=R.createFramebuffer(),A=R.createFramebuffer(),Te=new us(R),U=new sl,W=new Ol(R,V,H,U,Se,qe,Te),Ae=new os(T),je=new Mo(R),Je=new zo(R,je),Me=new cs(R,je,Te,Je),Ne=new fs(R,Me,je,Je,Te),We=new ds(R,Se,W),Ve=new Ho(U),Pe=new ol(T,Ae,V,Se,Je,Ve),Fe=new Il(T,U),Le=new dl,Be=new vl(V),Ue=new Ro(T,Ae,H,Ne,p,s),He=new El(T,Ne,Se),Ye=new Ll(R,Te,Se,H),Ge=new Bo(R,V,Te),Ke=new ls(R,V,Te),Te.programs=Pe.programs,T.capabilities=Se,T.extensions=V,T.properties=U,T.renderLists=Le,T.shadowMap=He,T.state=H,T.info=Te}m!==1009&&(w=new ms(m,t.width,t.height,o,r,i));let Ze=new Nl(T,R);this.xr=Ze,this.getContext=function(){return R},this.getContextAttributes=function(){return R.getContextAttributes()},this.forceContextLoss=function(){let e=V.get(`WEBGL_lose_context`);e&&e.loseContext()},this.forceContextRestore=function(){let e=V.get(`WEBGL_lose_context`);e&&e.restoreContext()},this.getPixelRatio=function(){return L},this.setPixelRatio=function(e){e!==void 0&&(L=e,this.setSize(F,I,!1))},this.getSize=function(e){return e.set(F,I)},this.setSize=function(e,n,r=!0){Ze.isPresenting?G(`WebGLRenderer: Can't change size while VR device is presenting.`):(F=e,I=n,t.width=Math.floor(e*L),t.height=Math.floor(n*L),r===!0&&(t.style.width=e+`px`,t.style.height=n+`px`),w!==null&&w.setSize(t.width,t.height),this.setViewport(0,0,e,n))},this.getDrawingBufferSize=function(e){return e.set(F*L,I*L).floor()},this.setDrawingBufferSize=function(e,n,r){F=e,I=n,L=r,t.width=Math.floor(e*r),t.height=Math.floor(n*r),this.setViewport(0,0,e,n)},this.setEffects=function(e){if(m===1009)K(`WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.`);else{if(e){for(let t=0;t<e.length;t++)if(e[t].isOutputPass===!0){G(`WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.`);break}}w.setEffects(e||[])}},this.getCurrentViewport=function(e){return e.copy(ne)},this.getViewport=function(e){return e.copy(ce)},this.setViewport=function(e,t,n,r){e.isVector4?ce.set(e.x,e.y,e.z,e.w):ce.set(e,t,n,r),H.viewport(ne.copy(ce).multiplyScalar(be()).round())},this.getScissor=function(e){return e.copy(le)},this.setScissor=function(e,t,n,r){e.isVector4?le.set(e.x,e.y,e.z,e.w):le.set(e,t,n,r),H.scissor(re.copy(le).multiplyScalar(be()).round())},this.getScissorTest=function(){return ue},this.setScissorTest=function(e){H.setScissorTest(ue=e)},this.setOpaqueSort=function(e){oe=e},this.setTransparentSort=function(e){se=e},this.getClearColor=function(e){return e.copy(Ue.getClearColor())},this.setClearColor=function(){Ue.setClearColor(...arguments)},this.getClearAlpha=function(){return Ue.getClearAlpha()},this.setClearAlpha=function(){Ue.setClearAlpha(...arguments)},this.clear=function(e=!0,t=!0,n=!0){let r=0;if(e){let e=!1;if(N!==null){let t=N.texture.format;e=h.has(t)}if(e){let e=N.texture.type,t=g.has(e),n=Ue.getClearColor(),r=Ue.getClearAlpha(),i=n.r,a=n.g,o=n.b;t?(_[0]=i,_[1]=a,_[2]=o,_[3]=r,R.clearBufferuiv(R.COLOR,0,_)):(v[0]=i,v[1]=a,v[2]=o,v[3]=r,R.clearBufferiv(R.COLOR,0,v))}else r|=R.COLOR_BUFFER_BIT}t&&(r|=R.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),n&&(r|=R.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),r!==0&&R.clear(r)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(e){e.setRenderer(this),D=e},this.dispose=function(){t.removeEventListener(`webglcontextlost`,Qe,!1),t.removeEventListener(`webglcontextrestored`,$e,!1),t.removeEventListener(`webglcontextcreationerror`,et,!1),Ue.dispose(),Le.dispose(),Be.dispose(),W.dispose(),U.dispose(),Ae.dispose(),Ne.dispose(),Me.dispose(),Je.dispose(),Ye.dispose(),Pe.dispose(),Ze.dispose(),Ze.removeEventListener(`sessionstart`,st),Ze.removeEventListener(`sessionend`,ct),lt.stop()};function Qe(e){e.preventDefault(),Ut(`WebGLRenderer: Context Lost.`),E=!0}function $e(){Ut(`WebGLRenderer: Context Restored.`),E=!1;let e=Te.autoReset,t=He.enabled,n=He.autoUpdate,r=He.needsUpdate,i=He.type;Xe(),Te.autoReset=e,He.enabled=t,He.autoUpdate=n,He.needsUpdate=r,He.type=i}function et(e){K(`WebGLRenderer: A WebGL context could not be created. Reason: `,e.statusMessage)}function tt(e){let t=e.target;t.removeEventListener(`dispose`,tt),nt(t)}function nt(e){rt(e),U.remove(e)}function rt(e){let t=U.get(e).programs;t!==void 0&&(t.forEach(function(e){Pe.releaseProgram(e)}),e.isShaderMaterial&&Pe.releaseShaderCache(e))}this.renderBufferDirect=function(e,t,n,r,i,a){t===null&&(t=ve);let o=i.isMesh&&i.matrixWorld.determinantAffine()<0,s=bt(e,t,n,r,i);H.setMaterial(r,o);let c=n.index,l=1;if(r.wireframe===!0){if(c=Me.getWireframeAttribute(n),c===void 0)return;l=2}let u=n.drawRange,d=n.attributes.position,f=u.start*l,p=(u.start+u.count)*l;a!==null&&(f=Math.max(f,a.start*l),p=Math.min(p,(a.start+a.count)*l)),c===null?d!=null&&(f=Math.max(f,0),p=Math.min(p,d.count)):(f=Math.max(f,0),p=Math.min(p,c.count));let m=p-f;if(m<0||m===1/0)return;Je.setup(i,r,s,n,c);let h,g=Ge;if(c!==null&&(h=je.get(c),g=Ke,g.setIndex(h)),i.isMesh)r.wireframe===!0?(H.setLineWidth(r.wireframeLinewidth*be()),g.setMode(R.LINES)):g.setMode(R.TRIANGLES);else if(i.isLine){let e=r.linewidth;e===void 0&&(e=1),H.setLineWidth(e*be()),i.isLineSegments?g.setMode(R.LINES):i.isLineLoop?g.setMode(R.LINE_LOOP):g.setMode(R.LINE_STRIP)}else i.isPoints?g.setMode(R.POINTS):i.isSprite&&g.setMode(R.TRIANGLES);if(i.isBatchedMesh){if(V.get(`WEBGL_multi_draw`))g.renderMultiDraw(i._multiDrawStarts,i._multiDrawCounts,i._multiDrawCount);else{let e=i._multiDrawStarts,t=i._multiDrawCounts,n=i._multiDrawCount,a=c?je.get(c).bytesPerElement:1,o=U.get(r).currentProgram.getUniforms();for(let r=0;r<n;r++)o.setValue(R,`_gl_DrawID`,r),g.render(e[r]/a,t[r])}}else if(i.isInstancedMesh)g.renderInstances(f,m,i.count);else if(n.isInstancedBufferGeometry){let e=n._maxInstanceCount===void 0?1/0:n._maxInstanceCount,t=Math.min(n.instanceCount,e);g.renderInstances(f,m,t)}else g.render(f,m)};function it(e,t,n,r){D!==null&&e.isNodeMaterial&&D.setObject(r,e),pe===!0&&Ve.setState(e,n,!1),e.transparent===!0&&e.side===2&&e.forceSinglePass===!1?(e.side=1,e.needsUpdate=!0,gt(e,t,r),e.side=0,e.needsUpdate=!0,gt(e,t,r),e.side=2):gt(e,t,r)}this.compile=function(e,t,n=null){n===null&&(n=e),D!==null&&D.renderStart(e,t,n),x=Be.get(n),x.init(t),C.push(x),n.traverseVisible(function(e){e.isLight&&e.layers.test(t.layers)&&(x.pushLight(e),e.castShadow&&x.pushShadow(e))}),e!==n&&e.traverseVisible(function(e){e.isLight&&e.layers.test(t.layers)&&(x.pushLight(e),e.castShadow&&x.pushShadow(e))}),x.setupLights(),D!==null&&D.updateLights(x.state.lightsArray),me=this.localClippingEnabled,pe=Ve.init(this.clippingPlanes,me),pe===!0&&Ve.setGlobalState(this.clippingPlanes,t),D!==null&&He.render(x.state.shadowsArray,n,t);let r=new Set;return e.traverse(function(e){if(!(e.isMesh||e.isPoints||e.isLine||e.isSprite))return;let i=e.material;if(i){if(Array.isArray(i))for(let a=0;a<i.length;a++){let o=i[a];it(o,n,t,e),r.add(o)}else it(i,n,t,e),r.add(i)}}),x=C.pop(),D!==null&&D.renderEnd(),r},this.compileAsync=function(e,t,n=null){let r=this.compile(e,t,n);return new Promise(t=>{function n(){r.forEach(function(e){let t=U.get(e).currentProgram;(t===void 0||t.isReady())&&r.delete(e)}),r.size===0?t(e):setTimeout(n,10)}V.get(`KHR_parallel_shader_compile`)===null?setTimeout(n,10):n()})};let at=null;function ot(e){at&&at(e)}function st(){lt.stop()}function ct(){lt.start()}let lt=new jo;lt.setAnimationLoop(ot),typeof self<`u`&&lt.setContext(self),this.setAnimationLoop=function(e){at=e,Ze.setAnimationLoop(e),e===null?lt.stop():lt.start()},Ze.addEventListener(`sessionstart`,st),Ze.addEventListener(`sessionend`,ct),this.render=function(e,t){if(t!==void 0&&t.isCamera!==!0){K(`WebGLRenderer.render: camera is not an instance of THREE.Camera.`);return}if(E===!0)return;D!==null&&D.renderStart(e,t);let n=Ze.enabled===!0&&Ze.isPresenting===!0,r=w!==null&&(N===null||n)&&w.begin(T,N);if(e.matrixWorldAutoUpdate===!0&&e.updateMatrixWorld(),t.parent===null&&t.matrixWorldAutoUpdate===!0&&t.updateMatrixWorld(),Ze.enabled===!0&&Ze.isPresenting===!0&&(w===null||w.isCompositing()===!1)&&(Ze.cameraAutoUpdate===!0&&Ze.updateCamera(t),t=Ze.getCamera()),e.isScene===!0&&e.onBeforeRender(T,e,t,N),x=Be.get(e,C.length),x.init(t),x.state.textureUnits=W.getTextureUnits(),C.push(x),he.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),t.isArrayCamera?fe.setFromArrayCamera(t):de.setFromProjectionMatrix(he,Lt,t.reversedDepth),me=this.localClippingEnabled,pe=Ve.init(this.clippingPlanes,me),b=Le.get(e,S.length),b.init(),S.push(b),this.info.render.frame++,Ze.enabled===!0&&Ze.isPresenting===!0){let e=T.xr.getDepthSensingMesh();e!==null&&ut(e,t,-1/0,T.sortObjects)}ut(e,t,0,T.sortObjects),b.finish(),D!==null&&D.updateLights(x.state.lightsArray),T.sortObjects===!0&&b.sort(oe,se),ye=Ze.enabled===!1||Ze.isPresenting===!1||Ze.hasDepthSensing()===!1,ye&&Ue.addToRenderList(b,e),this.info.autoReset===!0&&this.info.reset(),pe===!0&&Ve.beginShadows();let i=x.state.shadowsArray;if(He.render(i,e,t),pe===!0&&Ve.endShadows(),(r&&w.hasRenderPass())===!1){let n=b.opaque,r=b.transmissive;if(x.setupLights(),t.isArrayCamera){let i=t.cameras;if(r.length>0)for(let t=0,a=i.length;t<a;t++){let a=i[t];ft(n,r,e,a)}ye&&Ue.render(e);for(let t=0,n=i.length;t<n;t++){let n=i[t];dt(b,e,n,n.viewport)}}else r.length>0&&ft(n,r,e,t),ye&&Ue.render(e),dt(b,e,t)}N!==null&&M===0&&(W.updateMultisampleRenderTarget(N),W.updateRenderTargetMipmap(N)),r&&w.end(T),e.isScene===!0&&e.onAfterRender(T,e,t),Je.resetDefaultState(),ee=-1,te=null,C.pop(),C.length>0?(x=C[C.length-1],W.setTextureUnits(x.state.textureUnits),pe===!0&&Ve.setGlobalState(T.clippingPlanes,x.state.camera)):x=null,S.pop(),b=S.length>0?S[S.length-1]:null,D!==null&&D.renderEnd()};function ut(e,t,n,r){if(e.visible===!1)return;if(e.layers.test(t.layers)){if(e.isGroup)n=e.renderOrder;else if(e.isLOD)e.autoUpdate===!0&&e.update(t);else if(e.isLight)x.pushLight(e),e.castShadow&&x.pushShadow(e);else if(e.isSprite){let i=t.isArrayCamera?fe:de;if(!e.frustumCulled||e.intersectsFrustum(i)){r&&_e.setFromMatrixPosition(e.matrixWorld).applyMatrix4(he);let i=Ne.update(e),a=e.material;a.visible&&b.push(e,i,a,n,_e.z,null,t)}}else if(e.isMesh||e.isLine||e.isPoints){let i=t.isArrayCamera?fe:de;if(!e.frustumCulled||e.intersectsFrustum(i)){let i=Ne.update(e),a=e.material;if(r&&(e.boundingSphere===void 0?(i.boundingSphere===null&&i.computeBoundingSphere(),_e.copy(i.boundingSphere.center)):(e.boundingSphere===null&&e.computeBoundingSphere(),_e.copy(e.boundingSphere.center)),_e.applyMatrix4(e.matrixWorld).applyMatrix4(he)),Array.isArray(a)){let r=i.groups;for(let o=0,s=r.length;o<s;o++){let s=r[o],c=a[s.materialIndex];c&&c.visible&&b.push(e,i,c,n,_e.z,s,t)}}else a.visible&&b.push(e,i,a,n,_e.z,null,t)}}}let i=e.children;for(let e=0,a=i.length;e<a;e++)ut(i[e],t,n,r)}function dt(e,t,n,r){let{opaque:i,transmissive:a,transparent:o}=e;x.setupLightsView(n),pe===!0&&Ve.setGlobalState(T.clippingPlanes,n),r&&H.viewport(ne.copy(r)),i.length>0&&pt(i,t,n),a.length>0&&pt(a,t,n),o.length>0&&pt(o,t,n),H.buffers.depth.setTest(!0),H.buffers.depth.setMask(!0),H.buffers.color.setMask(!0),H.setPolygonOffset(!1)}function ft(e,t,n,r){if((n.isScene===!0?n.overrideMaterial:null)!==null)return;if(x.state.transmissionRenderTarget[r.id]===void 0){let e=V.has(`EXT_color_buffer_half_float`)||V.has(`EXT_color_buffer_float`);x.state.transmissionRenderTarget[r.id]=new Wn(1,1,{generateMipmaps:!0,type:e?Ee:xe,minFilter:B,samples:Math.max(4,Se.samples),stencilBuffer:i,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:jn.workingColorSpace})}let a=x.state.transmissionRenderTarget[r.id],o=r.viewport||ne;a.setSize(o.z*T.transmissionResolutionScale,o.w*T.transmissionResolutionScale);let s=T.getRenderTarget(),c=T.getActiveCubeFace(),l=T.getActiveMipmapLevel();T.setRenderTarget(a),T.getClearColor(P),ae=T.getClearAlpha(),ae<1&&T.setClearColor(16777215,.5),T.clear(),ye&&Ue.render(n);let u=T.toneMapping;T.toneMapping=0;let d=r.viewport;if(r.viewport!==void 0&&(r.viewport=void 0),x.setupLightsView(r),pe===!0&&Ve.setGlobalState(T.clippingPlanes,r),pt(e,n,r),W.updateMultisampleRenderTarget(a),W.updateRenderTargetMipmap(a),V.has(`WEBGL_multisampled_render_to_texture`)===!1){let e=!1;for(let i=0,a=t.length;i<a;i++){let{object:a,geometry:o,material:s,group:c}=t[i];if(s.side===2&&a.layers.test(r.layers)){let t=s.side;s.side=1,s.needsUpdate=!0,mt(a,n,r,o,s,c),s.side=t,s.needsUpdate=!0,e=!0}}e===!0&&(W.updateMultisampleRenderTarget(a),W.updateRenderTargetMipmap(a))}T.setRenderTarget(s,c,l),T.setClearColor(P,ae),d!==void 0&&(r.viewport=d),T.toneMapping=u}function pt(e,t,n){let r=t.isScene===!0?t.overrideMaterial:null;for(let i=0,a=e.length;i<a;i++){let a=e[i],{object:o,geometry:s,group:c}=a,l=a.material;l.allowOverride===!0&&r!==null&&(l=r),o.layers.test(n.layers)&&mt(o,t,n,s,l,c)}}function mt(e,t,n,r,i,a){D!==null&&i.isNodeMaterial&&D.setObject(e,i),e.onBeforeRender(T,t,n,r,i,a),e.modelViewMatrix.multiplyMatrices(n.matrixWorldInverse,e.matrixWorld),e.normalMatrix.getNormalMatrix(e.modelViewMatrix),i.onBeforeRender(T,t,n,r,e,a),i.transparent===!0&&i.side===2&&i.forceSinglePass===!1?(i.side=1,i.needsUpdate=!0,T.renderBufferDirect(n,t,r,i,e,a),i.side=0,i.needsUpdate=!0,T.renderBufferDirect(n,t,r,i,e,a),i.side=2):T.renderBufferDirect(n,t,r,i,e,a),e.onAfterRender(T,t,n,r,i,a)}function ht(e){let t=0;for(let n of e)n.texture!==null&&t++;return t}function gt(e,t,n){t.isScene!==!0&&(t=ve);let r=U.get(e),i=x.state.lights,a=x.state.shadowsArray,o=i.state.version,s=Pe.getParameters(e,i.state,a,t,n,x.state.lightProbeGridArray),c=Pe.getProgramCacheKey(s),l=r.programs;r.environment=e.isMeshStandardMaterial||e.isMeshLambertMaterial||e.isMeshPhongMaterial?t.environment:null,r.fog=t.fog;let u=e.isMeshStandardMaterial||e.isMeshLambertMaterial&&!e.envMap||e.isMeshPhongMaterial&&!e.envMap;r.envMap=Ae.get(e.envMap||r.environment,u),r.envMapRotation=r.environment!==null&&e.envMap===null?t.environmentRotation:e.envMapRotation,l===void 0&&(e.addEventListener(`dispose`,tt),l=new Map,r.programs=l,r.programVariants=new Map);let d=l.get(c);if(d!==void 0){if(r.currentProgram===d&&r.lightsStateVersion===o)return yt(e,s),d}else s.uniforms=Pe.getUniforms(e),D!==null&&e.isNodeMaterial&&D.build(e,n,s),e.onBeforeCompile(s,T),d=Pe.acquireProgram(s,c),l.set(c,d),r.uniforms=s.uniforms;let f=r.uniforms;return(!e.isShaderMaterial&&!e.isRawShaderMaterial||e.clipping===!0)&&(f.clippingPlanes=Ve.uniform),yt(e,s),r.needsLights=St(e),r.lightsStateVersion=o,r.needsLights&&(f.ambientLightColor.value=i.state.ambient,f.lightProbe.value=i.state.probe,f.sunLights.value=i.state.sun,f.sunLightShadows.value=i.state.sunShadow,f.directionalLights.value=i.state.directional,f.directionalLightShadows.value=i.state.directionalShadow,f.spotLights.value=i.state.spot,f.spotLightShadows.value=i.state.spotShadow,f.rectAreaLights.value=i.state.rectArea,f.ltc_1.value=i.state.rectAreaLTC1,f.ltc_2.value=i.state.rectAreaLTC2,f.pointLights.value=i.state.point,f.pointLightShadows.value=i.state.pointShadow,f.hemisphereLights.value=i.state.hemi,f.sunShadowMatrix.value=i.state.sunShadowMatrix,f.sunShadowCascade.value=i.state.sunShadowCascade,f.directionalShadowMatrix.value=i.state.directionalShadowMatrix,f.spotLightMatrix.value=i.state.spotLightMatrix,f.spotLightMap.value=i.state.spotLightMap,f.pointShadowMatrix.value=i.state.pointShadowMatrix),r.numLightProbeGrids=ht(x.state.lightProbeGridArray),r.currentProgram=d,r.uniformsList=null,d}function _t(e,t,n,r,i){let a=U.get(e),o=a.currentProgram.id+`,`+r+`,`+i,s=a.programVariants.get(o);return s===void 0?(s=gt(e,t,n),a.programVariants.set(o,s)):(a.currentProgram=s,a.uniformsList=null,a.outputColorSpace=r,a.toneMapping=i),s}function vt(e){if(e.uniformsList===null){let t=e.currentProgram.getUniforms();e.uniformsList=Cc.seqWithValue(t.seq,e.uniforms)}return e.uniformsList}function yt(e,t){let n=U.get(e);n.outputColorSpace=t.outputColorSpace,n.batching=t.batching,n.batchingColor=t.batchingColor,n.instancing=t.instancing,n.instancingColor=t.instancingColor,n.instancingMorph=t.instancingMorph,n.skinning=t.skinning,n.morphTargets=t.morphTargets,n.morphNormals=t.morphNormals,n.morphColors=t.morphColors,n.morphTargetsCount=t.morphTargetsCount,n.numClippingPlanes=t.numClippingPlanes,n.numIntersection=t.numClipIntersection,n.vertexAlphas=t.vertexAlphas,n.vertexTangents=t.vertexTangents,n.toneMapping=t.toneMapping}function bt(e,t,n,r,i){t.isScene!==!0&&(t=ve),W.resetTextureUnits();let a=t.fog,o=r.isMeshStandardMaterial||r.isMeshLambertMaterial||r.isMeshPhongMaterial?t.environment:null,s=N===null?T.outputColorSpace:N.isXRRenderTarget===!0?N.texture.colorSpace:jn.workingColorSpace,c=r.isMeshStandardMaterial||r.isMeshLambertMaterial&&!r.envMap||r.isMeshPhongMaterial&&!r.envMap,l=Ae.get(r.envMap||o,c),u=r.vertexColors===!0&&!!n.attributes.color&&n.attributes.color.itemSize===4,d=!!n.attributes.tangent&&(!!r.normalMap||r.anisotropy>0),f=!!n.morphAttributes.position,p=!!n.morphAttributes.normal,m=!!n.morphAttributes.color,h=0;r.toneMapped&&(N===null||N.isXRRenderTarget===!0)&&(h=T.toneMapping);let g=n.morphAttributes.position||n.morphAttributes.normal||n.morphAttributes.color,_=g===void 0?0:g.length,v=U.get(r),b=x.state.lights;if(pe===!0&&(me===!0||e!==te)){let t=e===te&&r.id===ee;Ve.setState(r,e,t)}let S=!1,C=!1;r.version===v.__version?v.needsLights&&v.lightsStateVersion!==b.state.version||i.isBatchedMesh&&v.batching===!1||!i.isBatchedMesh&&v.batching===!0||i.isBatchedMesh&&v.batchingColor===!0&&i._colorsTexture===null||i.isBatchedMesh&&v.batchingColor===!1&&i._colorsTexture!==null||i.isInstancedMesh&&v.instancing===!1||!i.isInstancedMesh&&v.instancing===!0||i.isSkinnedMesh&&v.skinning===!1||!i.isSkinnedMesh&&v.skinning===!0||i.isInstancedMesh&&v.instancingColor===!0&&i.instanceColor===null||i.isInstancedMesh&&v.instancingColor===!1&&i.instanceColor!==null||i.isInstancedMesh&&v.instancingMorph===!0&&i.morphTexture===null||i.isInstancedMesh&&v.instancingMorph===!1&&i.morphTexture!==null?S=!0:v.envMap===l?r.fog===!0&&v.fog!==a||v.numClippingPlanes!==void 0&&(v.numClippingPlanes!==Ve.numPlanes||v.numIntersection!==Ve.numIntersection)?S=!0:v.vertexAlphas===u&&v.vertexTangents===d&&v.morphTargets===f&&v.morphNormals===p&&v.morphColors===m&&v.morphTargetsCount===_&&v.numLightProbeGrids===ht(x.state.lightProbeGridArray)?(v.outputColorSpace!==s||v.toneMapping!==h)&&(C=!0):S=!0:S=!0:(S=!0,v.__version=r.version);let w=v.currentProgram;(S===!0||C===!0)&&(w=C===!0?_t(r,t,i,s,h):gt(r,t,i),D&&r.isNodeMaterial&&D.onUpdateProgram(r,w,v));let E=!1,O=!1,k=!1,A=w.getUniforms(),j=v.uniforms;if(H.useProgram(w.program)&&(E=!0,O=!0,k=!0),r.id!==ee&&(ee=r.id,O=!0),E||te!==e){H.buffers.depth.getReversed()&&e.reversedDepth!==!0&&(e._reversedDepth=!0,e.updateProjectionMatrix()),A.setValue(R,`projectionMatrix`,e.projectionMatrix),A.setValue(R,`viewMatrix`,e.matrixWorldInverse);let t=A.map.cameraPosition;t!==void 0&&t.setValue(R,ge.setFromMatrixPosition(e.matrixWorld)),Se.logarithmicDepthBuffer&&A.setValue(R,`logDepthBufFC`,2/(Math.log(e.far+1)/Math.LN2)),(r.isMeshPhongMaterial||r.isMeshToonMaterial||r.isMeshLambertMaterial||r.isMeshBasicMaterial||r.isMeshStandardMaterial||r.isShaderMaterial)&&A.setValue(R,`isOrthographic`,e.isOrthographicCamera===!0),te!==e&&(te=e,O=!0,k=!0)}if(v.needsLights&&(b.state.sunShadowMap.length>0&&A.setValue(R,`sunShadowMap`,b.state.sunShadowMap,W),b.state.directionalShadowMap.length>0&&A.setValue(R,`directionalShadowMap`,b.state.directionalShadowMap,W),b.state.spotShadowMap.length>0&&A.setValue(R,`spotShadowMap`,b.state.spotShadowMap,W),b.state.pointShadowMap.length>0&&A.setValue(R,`pointShadowMap`,b.state.pointShadowMap,W)),i.isSkinnedMesh){A.setOptional(R,i,`bindMatrix`),A.setOptional(R,i,`bindMatrixInverse`);let e=i.skeleton;e&&(e.boneTexture===null&&e.computeBoneTexture(),A.setValue(R,`boneTexture`,e.boneTexture,W))}i.isBatchedMesh&&(A.setOptional(R,i,`batchingTexture`),A.setValue(R,`batchingTexture`,i._matricesTexture,W),A.setOptional(R,i,`batchingIdTexture`),A.setValue(R,`batchingIdTexture`,i._indirectTexture,W),A.setOptional(R,i,`batchingColorTexture`),i._colorsTexture!==null&&A.setValue(R,`batchingColorTexture`,i._colorsTexture,W));let M=n.morphAttributes;if((M.position!==void 0||M.normal!==void 0||M.color!==void 0)&&We.update(i,n,w),(O||v.receiveShadow!==i.receiveShadow)&&(v.receiveShadow=i.receiveShadow,A.setValue(R,`receiveShadow`,i.receiveShadow)),(r.isMeshStandardMaterial||r.isMeshLambertMaterial||r.isMeshPhongMaterial)&&r.envMap===null&&t.environment!==null&&(j.envMapIntensity.value=t.environmentIntensity),j.dfgLUT!==void 0&&(j.dfgLUT.value=Bl()),O){if(A.setValue(R,`toneMappingExposure`,T.toneMappingExposure),v.needsLights&&xt(j,k),a&&r.fog===!0&&Fe.refreshFogUniforms(j,a),Fe.refreshMaterialUniforms(j,r,L,I,x.state.transmissionRenderTarget[e.id]),v.needsLights&&v.numLightProbeGrids>0){let e=y,t=0;for(let n of x.state.lightProbeGridArray)n.texture!==null&&(e.textures[t]=n.texture,e.min[t]=n.boundingBox.min,e.max[t]=n.boundingBox.max,e.resolution[t]=n.resolution,t++);for(let n in e)e[n].length=t;j.probesSH.value=e.textures,j.probesMin.value=e.min,j.probesMax.value=e.max,j.probesResolution.value=e.resolution}Cc.upload(R,vt(v),j,W)}if(r.isShaderMaterial&&r.uniformsNeedUpdate===!0&&(Cc.upload(R,vt(v),j,W),r.uniformsNeedUpdate=!1),r.isSpriteMaterial&&A.setValue(R,`center`,i.center),A.setValue(R,`modelViewMatrix`,i.modelViewMatrix),A.setValue(R,`normalMatrix`,i.normalMatrix),A.setValue(R,`modelMatrix`,i.matrixWorld),r.uniformsGroups!==void 0){let e=r.uniformsGroups;for(let t=0,n=e.length;t<n;t++){let n=e[t];Ye.update(n,w),Ye.bind(n,w)}}return w}function xt(e,t){e.ambientLightColor.needsUpdate=t,e.lightProbe.needsUpdate=t,e.sunLights.needsUpdate=t,e.sunLightShadows.needsUpdate=t,e.directionalLights.needsUpdate=t,e.directionalLightShadows.needsUpdate=t,e.pointLights.needsUpdate=t,e.pointLightShadows.needsUpdate=t,e.spotLights.needsUpdate=t,e.spotLightShadows.needsUpdate=t,e.rectAreaLights.needsUpdate=t,e.hemisphereLights.needsUpdate=t}function St(e){return e.isMeshLambertMaterial||e.isMeshToonMaterial||e.isMeshPhongMaterial||e.isMeshStandardMaterial||e.isShadowMaterial||e.isShaderMaterial&&e.lights===!0}this.getActiveCubeFace=function(){return j},this.getActiveMipmapLevel=function(){return M},this.getRenderTarget=function(){return N},this.setRenderTargetTextures=function(e,t,n){let r=U.get(e);r.__autoAllocateDepthBuffer=e.resolveDepthBuffer===!1,r.__autoAllocateDepthBuffer===!1&&(r.__useRenderToTexture=!1),U.get(e.texture).__webglTexture=t,U.get(e.depthTexture).__webglTexture=r.__autoAllocateDepthBuffer?void 0:n,r.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(e,t){let n=U.get(e);n.__webglFramebuffer=t,n.__useDefaultFramebuffer=t===void 0},this.setRenderTarget=function(e,t=0,n=0){N=e,j=t,M=n;let r=null,i=!1,a=!1;if(e){let o=U.get(e);if(o.__useDefaultFramebuffer!==void 0){H.bindFramebuffer(R.FRAMEBUFFER,o.__webglFramebuffer),ne.copy(e.viewport),re.copy(e.scissor),ie=e.scissorTest,H.viewport(ne),H.scissor(re),H.setScissorTest(ie),ee=-1;return}if(o.__webglFramebuffer===void 0)W.setupRenderTarget(e);else if(o.__hasExternalTextures)W.rebindTextures(e,U.get(e.texture).__webglTexture,U.get(e.depthTexture).__webglTexture);else if(e.depthBuffer){let t=e.depthTexture;if(o.__boundDepthTexture!==t){if(t!==null&&U.has(t)&&(e.width!==t.image.width||e.height!==t.image.height))throw Error(`THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.`);W.setupDepthRenderbuffer(e)}}let s=e.texture;(s.isData3DTexture||s.isDataArrayTexture||s.isCompressedArrayTexture)&&(a=!0);let c=U.get(e).__webglFramebuffer;e.isWebGLCubeRenderTarget?(r=Array.isArray(c[t])?c[t][n]:c[t],i=!0):r=e.samples>0&&W.useMultisampledRTT(e)===!1?U.get(e).__webglMultisampledFramebuffer:Array.isArray(c)?c[n]:c,ne.copy(e.viewport),re.copy(e.scissor),ie=e.scissorTest}else ne.copy(ce).multiplyScalar(L).floor(),re.copy(le).multiplyScalar(L).floor(),ie=ue;if(n!==0&&(r=O),H.bindFramebuffer(R.FRAMEBUFFER,r)&&H.drawBuffers(e,r),H.viewport(ne),H.scissor(re),H.setScissorTest(ie),i){let r=U.get(e.texture);R.framebufferTexture2D(R.FRAMEBUFFER,R.COLOR_ATTACHMENT0,R.TEXTURE_CUBE_MAP_POSITIVE_X+t,r.__webglTexture,n)}else if(a){let r=t;for(let t=0;t<e.textures.length;t++){let i=U.get(e.textures[t]);R.framebufferTextureLayer(R.FRAMEBUFFER,R.COLOR_ATTACHMENT0+t,i.__webglTexture,n,r)}}else if(e!==null&&n!==0){let t=U.get(e.texture);R.framebufferTexture2D(R.FRAMEBUFFER,R.COLOR_ATTACHMENT0,R.TEXTURE_2D,t.__webglTexture,n)}ee=-1};function Ct(e){let t=U.get(e);return(t.__readFormat!==e.format||t.__readType!==e.type)&&(t.__readFormat=e.format,t.__readType=e.type,t.__formatReadable=Se.textureFormatReadable(e.format),t.__typeReadable=Se.textureTypeReadable(e.type)),t}this.readRenderTargetPixels=function(e,t,n,r,i,a,o,s=0){if(!(e&&e.isWebGLRenderTarget)){K(`WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.`);return}let c=U.get(e).__webglFramebuffer;if(e.isWebGLCubeRenderTarget&&o!==void 0&&(c=c[o],Array.isArray(c)&&(c=c[0])),c){H.bindFramebuffer(R.FRAMEBUFFER,c);try{let o=e.textures[s],c=o.format,l=o.type;e.textures.length>1&&R.readBuffer(R.COLOR_ATTACHMENT0+s);let u=Ct(o);if(u.__formatReadable===!1){K(`WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.`);return}if(u.__typeReadable===!1){K(`WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.`);return}t>=0&&t<=e.width-r&&n>=0&&n<=e.height-i&&R.readPixels(t,n,r,i,qe.convert(c),qe.convert(l),a)}finally{let e=N===null?null:U.get(N).__webglFramebuffer;H.bindFramebuffer(R.FRAMEBUFFER,e)}}},this.readRenderTargetPixelsAsync=async function(e,t,n,r,i,a,o,s=0){if(!(e&&e.isWebGLRenderTarget))throw Error(`THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.`);let c=U.get(e).__webglFramebuffer;if(e.isWebGLCubeRenderTarget&&o!==void 0&&(c=c[o],Array.isArray(c)&&(c=c[0])),c){if(t>=0&&t<=e.width-r&&n>=0&&n<=e.height-i){H.bindFramebuffer(R.FRAMEBUFFER,c);let o=e.textures[s],l=o.format,u=o.type;e.textures.length>1&&R.readBuffer(R.COLOR_ATTACHMENT0+s);let d=Ct(o);if(d.__formatReadable===!1)throw Error(`THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.`);if(d.__typeReadable===!1)throw Error(`THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.`);let f=R.createBuffer();R.bindBuffer(R.PIXEL_PACK_BUFFER,f),R.bufferData(R.PIXEL_PACK_BUFFER,a.byteLength,R.STREAM_READ),R.readPixels(t,n,r,i,qe.convert(l),qe.convert(u),0),R.bindBuffer(R.PIXEL_PACK_BUFFER,null);let p=N===null?null:U.get(N).__webglFramebuffer;H.bindFramebuffer(R.FRAMEBUFFER,p);let m=R.fenceSync(R.SYNC_GPU_COMMANDS_COMPLETE,0);return R.flush(),await Kt(R,m,4),R.bindBuffer(R.PIXEL_PACK_BUFFER,f),R.getBufferSubData(R.PIXEL_PACK_BUFFER,0,a),R.bindBuffer(R.PIXEL_PACK_BUFFER,null),R.deleteBuffer(f),R.deleteSync(m),a}throw Error(`THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.`)}},this.copyFramebufferToTexture=function(e,t=null,n=0){let r=2**-n,i=Math.floor(e.image.width*r),a=Math.floor(e.image.height*r),o=t===null?0:t.x,s=t===null?0:t.y;W.setTexture2D(e,0),R.copyTexSubImage2D(R.TEXTURE_2D,n,0,0,o,s,i,a),H.unbindTexture()},this.copyTextureToTexture=function(e,t,n=null,r=null,i=0,a=0){let o,s,c,l,u,d,f,p,m,h=e.isCompressedTexture?e.mipmaps[a]:e.image;if(n!==null)o=n.max.x-n.min.x,s=n.max.y-n.min.y,c=n.isBox3?n.max.z-n.min.z:1,l=n.min.x,u=n.min.y,d=n.isBox3?n.min.z:0;else{let t=2**-i;o=Math.floor(h.width*t),s=Math.floor(h.height*t),c=e.isDataArrayTexture?h.depth:e.isData3DTexture?Math.floor(h.depth*t):1,l=0,u=0,d=0}r===null?(f=0,p=0,m=0):(f=r.x,p=r.y,m=r.z);let g=qe.convert(t.format),_=qe.convert(t.type),v;t.isData3DTexture?(W.setTexture3D(t,0),v=R.TEXTURE_3D):t.isDataArrayTexture||t.isCompressedArrayTexture?(W.setTexture2DArray(t,0),v=R.TEXTURE_2D_ARRAY):(W.setTexture2D(t,0),v=R.TEXTURE_2D),H.activeTexture(R.TEXTURE0),H.pixelStorei(R.UNPACK_FLIP_Y_WEBGL,t.flipY),H.pixelStorei(R.UNPACK_PREMULTIPLY_ALPHA_WEBGL,t.premultiplyAlpha),H.pixelStorei(R.UNPACK_ALIGNMENT,t.unpackAlignment);let y=H.getParameter(R.UNPACK_ROW_LENGTH),b=H.getParameter(R.UNPACK_IMAGE_HEIGHT),x=H.getParameter(R.UNPACK_SKIP_PIXELS),S=H.getParameter(R.UNPACK_SKIP_ROWS),C=H.getParameter(R.UNPACK_SKIP_IMAGES);H.pixelStorei(R.UNPACK_ROW_LENGTH,h.width),H.pixelStorei(R.UNPACK_IMAGE_HEIGHT,h.height),H.pixelStorei(R.UNPACK_SKIP_PIXELS,l),H.pixelStorei(R.UNPACK_SKIP_ROWS,u),H.pixelStorei(R.UNPACK_SKIP_IMAGES,d);let w=e.isDataArrayTexture||e.isData3DTexture,T=t.isDataArrayTexture||t.isData3DTexture;if(e.isDepthTexture){let n=U.get(e),r=U.get(t),h=U.get(n.__renderTarget),g=U.get(r.__renderTarget);H.bindFramebuffer(R.READ_FRAMEBUFFER,h.__webglFramebuffer),H.bindFramebuffer(R.DRAW_FRAMEBUFFER,g.__webglFramebuffer);for(let n=0;n<c;n++)w&&(R.framebufferTextureLayer(R.READ_FRAMEBUFFER,R.COLOR_ATTACHMENT0,U.get(e).__webglTexture,i,d+n),R.framebufferTextureLayer(R.DRAW_FRAMEBUFFER,R.COLOR_ATTACHMENT0,U.get(t).__webglTexture,a,m+n)),R.blitFramebuffer(l,u,l+o,u+s,f,p,f+o,p+s,R.DEPTH_BUFFER_BIT,R.NEAREST);H.bindFramebuffer(R.READ_FRAMEBUFFER,null),H.bindFramebuffer(R.DRAW_FRAMEBUFFER,null)}else if(i!==0||e.isRenderTargetTexture||U.has(e)){let n=U.get(e),r=U.get(t);H.bindFramebuffer(R.READ_FRAMEBUFFER,k),H.bindFramebuffer(R.DRAW_FRAMEBUFFER,A);for(let e=0;e<c;e++)w?R.framebufferTextureLayer(R.READ_FRAMEBUFFER,R.COLOR_ATTACHMENT0,n.__webglTexture,i,d+e):R.framebufferTexture2D(R.READ_FRAMEBUFFER,R.COLOR_ATTACHMENT0,R.TEXTURE_2D,n.__webglTexture,i),T?R.framebufferTextureLayer(R.DRAW_FRAMEBUFFER,R.COLOR_ATTACHMENT0,r.__webglTexture,a,m+e):R.framebufferTexture2D(R.DRAW_FRAMEBUFFER,R.COLOR_ATTACHMENT0,R.TEXTURE_2D,r.__webglTexture,a),i===0?T?R.copyTexSubImage3D(v,a,f,p,m+e,l,u,o,s):R.copyTexSubImage2D(v,a,f,p,l,u,o,s):R.blitFramebuffer(l,u,l+o,u+s,f,p,f+o,p+s,R.COLOR_BUFFER_BIT,R.NEAREST);H.bindFramebuffer(R.READ_FRAMEBUFFER,null),H.bindFramebuffer(R.DRAW_FRAMEBUFFER,null)}else T?e.isDataTexture||e.isData3DTexture?R.texSubImage3D(v,a,f,p,m,o,s,c,g,_,h.data):t.isCompressedArrayTexture?R.compressedTexSubImage3D(v,a,f,p,m,o,s,c,g,h.data):R.texSubImage3D(v,a,f,p,m,o,s,c,g,_,h):e.isDataTexture?R.texSubImage2D(R.TEXTURE_2D,a,f,p,o,s,g,_,h.data):e.isCompressedTexture?R.compressedTexSubImage2D(R.TEXTURE_2D,a,f,p,h.width,h.height,g,h.data):R.texSubImage2D(R.TEXTURE_2D,a,f,p,o,s,g,_,h);H.pixelStorei(R.UNPACK_ROW_LENGTH,y),H.pixelStorei(R.UNPACK_IMAGE_HEIGHT,b),H.pixelStorei(R.UNPACK_SKIP_PIXELS,x),H.pixelStorei(R.UNPACK_SKIP_ROWS,S),H.pixelStorei(R.UNPACK_SKIP_IMAGES,C),a===0&&t.generateMipmaps===!0&&t.mipmapsAutoUpdate===!0&&R.generateMipmap(v),H.unbindTexture()},this.initRenderTarget=function(e){U.get(e).__webglFramebuffer===void 0&&W.setupRenderTarget(e)},this.initTexture=function(e){e.isCubeTexture?W.setTextureCube(e,0):e.isData3DTexture?W.setTexture3D(e,0):e.isDataArrayTexture||e.isCompressedArrayTexture?W.setTexture2DArray(e,0):W.setTexture2D(e,0),H.unbindTexture()},this.resetState=function(){j=0,M=0,N=null,H.reset(),Je.reset()},typeof __THREE_DEVTOOLS__<`u`&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent(`observe`,{detail:this}))}get coordinateSystem(){return Lt}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=jn._getDrawingBufferColorSpace(e),t.unpackColorSpace=jn._getUnpackColorSpace()}},Hl=[`440154`,`48186a`,`472d7b`,`424086`,`3b528b`,`33638d`,`2c728e`,`26828e`,`21918c`,`1fa088`,`28ae80`,`3fbc73`,`5ec962`,`84d44b`,`addc30`,`d8e219`,`fde725`].map(cu),Ul=[`053061`,`2166ac`,`4393c3`,`92c5de`,`d1e5f0`,`f7f7f7`,`fddbc7`,`f4a582`,`d6604d`,`b2182b`,`67001f`].map(cu),Wl=[179,0,0],Gl=[120,120,120],Kl=.002,ql=[1,2,2.5,5,10];function Jl(e){if(!(e>0)||!Number.isFinite(e))return 1;let t=10**Math.floor(Math.log10(e));return(ql.find(n=>n*t>=e*(1-1e-9))??10)*t}function Yl(e,t,n){if(!(t-e>1e-9*Math.max(Math.abs(e),Math.abs(t)))){let n=Math.abs(e)*.5||.5;[e,t]=[e-n,e+n]}for(let r=(t-e)/n;;r*=1.01){let i=Jl(r),[a,o]=[Math.floor(e/i+1e-9),Math.ceil(t/i-1e-9)];if(o-a<=n)return Array.from({length:o-a+1},(e,t)=>Zl((a+t)*i,i))}}function Xl(e,t,n){let r=Jl((t-e)/Math.max(n,1)),i=[];for(let n=Math.ceil(e/r-1e-9);n*r<=t+1e-9*r;n++)i.push(Zl(n*r,r));return i}function Zl(e,t){let n=Math.max(0,Math.min(15,2-Math.floor(Math.log10(t))));return Number(e.toFixed(n))+0}function Ql(e,t,n,r,i=14){let[a,o]=r??[e,t],s=n&&$l(a,o),c=Yl(a,o,i),[l,u]=[c[0],(c[c.length-1]-c[0])/(c.length-1)];r&&(c[0]=Math.max(c[0],a),c[c.length-1]=Math.min(c[c.length-1],o));let[d,f]=[c[0],c[c.length-1]],p=Math.max(Math.abs(d),Math.abs(f));return{levels:c,origin:l,step:u,colours:c.slice(1).map((e,t)=>{let n=(c[t]+e)/2;return s?su(Ul,(n/p+1)/2):su(Hl,(n-d)/(f-d))}),diverging:s,over:Wl,under:Gl,min:e,max:t}}function $l(e,t){let n=1e-4*Math.max(Math.abs(e),Math.abs(t));return e<-n&&t>n}function eu(e,t){let{levels:n,origin:r,step:i}=e,a=n.length-1,o=Kl*i;return t<n[0]-o?-1:t>n[a]+o?a:Math.min(Math.max(Math.floor((t-r)/i),0),a-1)}function tu(e,t=4){if(!Number.isFinite(e))return`–`;if(e===0)return`0`;let n=Math.abs(e);return(n>=1e6||n<1e-4?e.toExponential(t-1):ou(e,t)).replace(/-/g,`−`)}function nu(e,t=4){return tu(Number(e.toPrecision(t))===0?0:e,t).replace(/(\.\d*?)0+$/,`$1`).replace(/\.$/,``)}function ru(e){let t=Math.max(...e.map(Math.abs),1e-300),n=e.map(e=>Math.abs(e)<1e-9*t?0:e);if(t>=1e6||t<.001)return n.map(e=>tu(e,3));let r=Math.max(...n.map(e=>iu(e,1e-9*t)));return n.map(e=>e.toFixed(r).replace(/-/g,`−`))}function iu(e,t){let n=0;for(;n<12&&Math.abs(Number(e.toFixed(n))-e)>t;)n++;return n}function au([e,t,n],r=1){return r===1?`rgb(${e} ${t} ${n})`:`rgb(${e} ${t} ${n} / ${r})`}function ou(e,t){let n=Math.max(0,t-1-Math.floor(Math.log10(Math.abs(e))));return e.toFixed(Math.min(n,12))}function su(e,t){let n=Math.min(Math.max(t,0),1)*(e.length-1),r=Math.min(Math.floor(n),e.length-2),i=n-r;return e[r].map((t,n)=>Math.round(t+i*(e[r+1][n]-t)))}function cu(e){return[0,2,4].map(t=>parseInt(e.slice(t,t+2),16))}var lu=300;function uu(e){let{nodes:t,elements:n,elementCount:r}=e,i=new Float64Array(4*r),[a,o,s,c]=[1/0,1/0,-1/0,-1/0],l=0;for(let e=0;e<r;e++){let[r,u,d,f]=[1/0,1/0,-1/0,-1/0];for(let i=0;i<9;i++){let a=2*n[9*e+i],[o,s]=[t[a],t[a+1]];o<r&&(r=o),s<u&&(u=s),o>d&&(d=o),s>f&&(f=s)}i.set([r,u,d,f],4*e),l+=(d-r)*(f-u),a=Math.min(a,r),o=Math.min(o,u),s=Math.max(s,d),c=Math.max(c,f)}let u=Math.max(Math.sqrt((s-a)*(c-o)*lu/Math.max(r,1)),1e-9),d=Math.min(32,Math.max(1,Math.ceil((s-a)/u))),f=Math.min(32,Math.max(1,Math.ceil((c-o)/u))),p=e=>{let[t,n]=[((i[4*e]+i[4*e+2])/2-a)/(s-a||1),((i[4*e+1]+i[4*e+3])/2-o)/(c-o||1)];return Math.min(f-1,Math.floor(n*f))*d+Math.min(d-1,Math.floor(t*d))},m=Array.from({length:d*f},()=>[]);for(let e=0;e<r;e++)m[p(e)].push(e);let h=new Uint32Array((ie.length+P.length)*r),g=[],[_,v]=[0,ie.length*r];for(let e of m){if(!e.length)continue;let t=[1/0,1/0,-1/0,-1/0];g.push({box:t,fine:[_,e.length*ie.length],coarse:[v,e.length*P.length]});for(let r of e){for(let e of ie)h[_++]=n[9*r+e];for(let e of P)h[v++]=n[9*r+e];t[0]=Math.min(t[0],i[4*r]),t[1]=Math.min(t[1],i[4*r+1]),t[2]=Math.max(t[2],i[4*r+2]),t[3]=Math.max(t[3],i[4*r+3])}}return{faces:h,tiles:g,side:Math.sqrt(l/Math.max(r,1))}}function du(e,[t,n,r,i],a){let o=[];for(let s of e.tiles){if(s.box[0]>r||s.box[2]<t||s.box[1]>i||s.box[3]<n)continue;let[e,c]=a?s.coarse:s.fine,l=o[o.length-1];l&&l[0]+l[1]===e?l[1]+=c:o.push([e,c])}return o}var fu=3.5;function pu(e){let{elements:t,elementCount:n}=e,r=new Uint8Array(e.nodeCount),i=[];for(let e=0;e<n;e++)for(let[n,a,o]of ae){let[s,c,l]=[t[9*e+n],t[9*e+a],t[9*e+o]];r[l]||(r[l]=1,i.push(s,l,l,c))}return Uint32Array.from(i)}function mu(e){let{elements:t,elementCount:n}=e,r=new Uint8Array(e.nodeCount);for(let e=0;e<n;e++)for(let[,,n]of ae)r[t[9*e+n]]+=1;let i=[];for(let e=0;e<n;e++)for(let[n,a,o]of ae){let s=t[9*e+o];r[s]===1&&i.push(t[9*e+n],s,t[9*e+a])}return Uint32Array.from(i)}var hu={paper:`#ffffff`,ink:`#1b1f23`,ink2:`#545c66`,line:`#d3d8dd`,halo:`rgb(255 255 255 / 0.85)`,hatch:`#404040`,load:`#b3135f`,support:`#16703a`,soil:`#7a5a1e`,section:`#0b5fa5`,accent:`#0b5fa5`},gu={paper:`#16191d`,ink:`#e6e9ec`,ink2:`#a7b0ba`,line:`#343a42`,halo:`rgb(16 19 23 / 0.85)`,hatch:`#c8d0d8`,load:`#ff7eb6`,support:`#6fce8d`,soil:`#d2ac69`,section:`#6fb3ef`,accent:`#6fb3ef`};function _u(e){return[1,3,5].map(t=>parseInt(e.slice(t,t+2),16))}function vu(e){return e===`dark`?gu:hu}var yu=255,bu=254,xu=253;function Su(e,t,n,r,i,a,o){let s=new Uint8Array(a*o).fill(yu),c=r.contact?new Uint8Array(a*o):null,{nodes:l}=e,{values:u,contact:d,scale:f}=r,p=Tu(f),[m,h]=[a/2-i.x*i.scale,o/2+i.y*i.scale];for(let[e,r]of n)for(let n=e;n<e+r;n+=3){let[e,r,f]=[t[n],t[n+1],t[n+2]],g=m+l[2*e]*i.scale,_=h-l[2*e+1]*i.scale,v=m+l[2*r]*i.scale,y=h-l[2*r+1]*i.scale,b=m+l[2*f]*i.scale,x=h-l[2*f+1]*i.scale,S=Math.max(0,Math.ceil(Math.min(_,y,x)-.5)),C=Math.min(o-1,Math.floor(Math.max(_,y,x)-.5));if(S>C||Math.max(g,v,b)<0||Math.min(g,v,b)>a)continue;let w=(v-g)*(x-_)-(b-g)*(y-_);if(w===0)continue;let T=t=>{let[n,i]=[t[r]-t[e],t[f]-t[e]],a=(n*(x-_)-i*(y-_))/w,o=(i*(v-g)-n*(b-g))/w;return[t[e]-a*g-o*_,a,o]},[E,D,O]=T(u),[k,A,j]=d?T(d):[0,0,0];for(let e=S;e<=C;e++){let t=e+.5,[n,r]=[1/0,-1/0],i=(e,i,a,o)=>{if(i<t==o<t)return;let s=i<o?e+(t-i)/(o-i)*(a-e):a+(t-o)/(i-o)*(e-a);s<n&&(n=s),s>r&&(r=s)};i(g,_,v,y),i(v,y,b,x),i(b,x,g,_);let o=Math.max(0,Math.ceil(n-.5)),l=Math.min(a-1,Math.ceil(r-.5)-1),u=e*a;for(let e=o;e<=l;e++)s[u+e]=p(E+D*(e+.5)+O*t),c&&k+A*(e+.5)+j*t>0&&(c[u+e]=1)}}return{width:a,height:o,bands:s,lifted:c}}function Cu(e,t,n,r,i,a){let{width:o,height:s,bands:c,lifted:l}=e,u=[];t.scale.colours.forEach((e,t)=>{u[t]=e}),u[bu]=t.scale.over,u[xu]=t.scale.under;let d=new Uint8ClampedArray(4*o*s),f=12*r,p=o/2-n.x*n.scale-(s/2+n.y*n.scale),m=[];for(let e=0,n=0;e<s;e++)for(let h=0;h<o;h++,n++){let g=c[n];if(g===yu)continue;let[_,v,y]=u[g],b=h+1<o?c[n+1]:g,x=e+1<s?c[n+o]:g;if(t.lines&&(b!==g&&b<xu||x!==g&&x<xu)&&g<xu&&([_,v,y]=[_*.68,v*.68,y*.68]),l){if(l[n]){let t=h-e-p,n=t-Math.floor(t/f)*f<1.4*r;[_,v,y]=[i[0]+.45*(_-i[0]),i[1]+.45*(v-i[1]),i[2]+.45*(y-i[2])],n&&([_,v,y]=[.45*_+.55*a[0],.45*v+.55*a[1],.45*y+.55*a[2]])}let t=h+1<o&&c[n+1]!==yu&&l[n+1]!==l[n],u=e+1<s&&c[n+o]!==yu&&l[n+o]!==l[n];(t||u)&&m.push(n)}d[4*n]=_,d[4*n+1]=v,d[4*n+2]=y,d[4*n+3]=255}for(let[e,t]of[[2.2*r,255],[.9*r,0]]){let n=Math.ceil(e);for(let r of m){let[i,a]=[r%o,Math.floor(r/o)];for(let l=-n;l<=n;l++)for(let u=-n;u<=n;u++){if((u-.5)**2+(l-.5)**2>e*e||i+u<0||i+u>=o||a+l<0||a+l>=s)continue;let n=r+l*o+u;c[n]!==yu&&d.fill(t,4*n,4*n+3)}}}return d}var wu=class{canvas=document.createElement(`canvas`);cost=0;context=this.canvas.getContext(`2d`,{willReadFrequently:!0});mesh=null;tiling=null;sides=null;picture=null;look=vu(`light`);setMesh(e){this.mesh=e,this.tiling=e?uu(e):null,this.sides=null}setPicture(e){this.picture=e}setTheme(e){this.look=vu(e)}draw(e,t,n,r){let i=performance.now(),[a,o]=[Math.max(1,Math.round(t*r)),Math.max(1,Math.round(n*r))];(this.canvas.width!==a||this.canvas.height!==o)&&([this.canvas.width,this.canvas.height]=[a,o]);let{context:s,mesh:c,tiling:l,picture:u}=this;if(s.fillStyle=this.look.paper,s.fillRect(0,0,a,o),!c||!l||!u)return;let d={...e,scale:e.scale*r},[f,p]=[a/2/d.scale,o/2/d.scale],m=du(l,[e.x-f,e.y-p,e.x+f,e.y+p],l.side*d.scale<fu),h=Su(c,l.faces,m,u,d,a,o);s.putImageData(new ImageData(Cu(h,u,d,r,_u(this.look.paper),_u(this.look.hatch)),a,o),0,0),u.mesh&&this.drawSides(s,d,a,o,r),this.cost=performance.now()-i}dispose(){this.canvas.remove()}drawSides(e,t,n,r,i){let{nodes:a}=this.mesh;this.sides??=pu(this.mesh),e.strokeStyle=`rgb(0 0 0 / 0.28)`,e.lineWidth=i,e.beginPath();for(let i=0;i<this.sides.length;i+=2){let[o,s]=[2*this.sides[i],2*this.sides[i+1]];e.moveTo(n/2+(a[o]-t.x)*t.scale,r/2-(a[o+1]-t.y)*t.scale),e.lineTo(n/2+(a[s]-t.x)*t.scale,r/2-(a[s+1]-t.y)*t.scale)}e.stroke()}};function Tu(e){let t=e.colours.length;return n=>{let r=eu(e,n);return r<0?xu:r===t?bu:r}}function Eu(e,t){let n=document.documentElement.dataset.painter,r=n===`webgl`,i=n===`processor`?null:e.getContext(`webgl2`,{...t,failIfMajorPerformanceCaveat:!r});if(!i)throw Error(`no WebGL 2`);if(!r&&Du(i))throw i.getExtension(`WEBGL_lose_context`)?.loseContext(),Error(`WebGL without a graphics card`);return i}function Du(e){let t=e.getExtension(`WEBGL_debug_renderer_info`),n=String(e.getParameter(t?t.UNMASKED_RENDERER_WEBGL:e.RENDERER));return/swiftshader|llvmpipe|softpipe|software|basic render/i.test(n)}var Ou=`
in vec3 position;
in float value;
in float contact;
uniform mat4 projectionMatrix;
uniform mat4 modelViewMatrix;
out float vValue;
out float vContact;
void main() {
  vValue = value;
  vContact = contact;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`,ku=`
uniform sampler2D uBands;
uniform float uOrigin, uStep, uCount, uLow, uHigh, uLines, uRatio;
uniform vec3 uOver, uUnder;
vec3 banded(float value) {
  float f = (value - uOrigin) / uStep;
  float slope = length(vec2(dFdx(f), dFdy(f)));
  float band = clamp(floor(f), 0.0, uCount - 1.0);
  vec3 colour = texelFetch(uBands, ivec2(int(band), 0), 0).rgb;
  if (value < uLow - ${Kl} * uStep) colour = uUnder;
  if (value > uHigh + ${Kl} * uStep) colour = uOver;
  // a thin line between bands; none where they are too close, nor on a plateau that lies on a limit
  float nearest = floor(f + 0.5);
  if (uLines > 0.0 && nearest > 0.5 && nearest < uCount - 0.5) {
    float pixels = abs(f - nearest) / max(slope, 1e-7) / uRatio;
    float seen = smoothstep(2e-5, 1e-4, slope * uRatio) * (1.0 - smoothstep(0.08, 0.2, slope * uRatio));
    colour *= 1.0 - 0.38 * uLines * seen * (1.0 - smoothstep(0.35, 0.95, pixels));
  }
  return colour;
}`,Au=`
precision highp float;
in float vValue;
in float vContact;
uniform float uContact;
uniform vec2 uAnchor;
uniform vec3 uPaper, uHatch;
out vec4 result;
${ku}
void main() {
  vec3 colour = banded(vValue);
  if (uContact > 0.0) {
    float slope = length(vec2(dFdx(vContact), dFdy(vContact)));
    if (vContact > 0.0) {
      vec2 p = (gl_FragCoord.xy - uAnchor) / uRatio;
      float stripe = abs(fract((p.x + p.y) / ${12 .toFixed(1)}) - 0.5) * ${12 .toFixed(1)} * 0.7071;
      colour = mix(mix(colour, uPaper, 0.55), uHatch, 0.6 * (1.0 - smoothstep(0.3, 1.0, stripe)));
    }
    float d = abs(vContact) / max(slope, 1e-30) / uRatio;
    colour = mix(vec3(1.0), colour, smoothstep(1.6, 2.4, d));
    colour = mix(vec3(0.0), colour, smoothstep(0.6, 1.3, d));
  }
  result = vec4(colour, 1.0);
}`;function ju(){return{uBands:{value:null},uOrigin:{value:0},uStep:{value:1},uCount:{value:1},uLow:{value:0},uHigh:{value:1},uLines:{value:1},uRatio:{value:1},uOver:{value:[1,0,1]},uUnder:{value:[0,1,0]}}}function Mu(e,t,n){let r=t.colours.length,i=new Uint8Array(4*r);t.colours.forEach((e,t)=>i.set([...e,255],4*t)),e.uBands.value?.dispose();let a=new Zi(i,r,1);a.minFilter=a.magFilter=ve,a.needsUpdate=!0,e.uBands.value=a,e.uOrigin.value=t.origin,e.uStep.value=t.step,e.uCount.value=r,e.uLow.value=t.levels[0],e.uHigh.value=t.levels[r],e.uLines.value=+!!n,e.uOver.value=t.over.map(e=>e/255),e.uUnder.value=t.under.map(e=>e/255)}var Nu=class{canvas=document.createElement(`canvas`);renderer;world=new Ar;camera=new lo(-1,1,1,-1,-1,1);uniforms={...ju(),uContact:{value:0},uAnchor:{value:new q},uPaper:{value:[1,1,1]},uHatch:{value:[.25,.25,.25]}};material=new Ma({glslVersion:It,vertexShader:Ou,fragmentShader:Au,uniforms:this.uniforms,depthTest:!1,depthWrite:!1,side:2});faces=new Ji(new wi,[this.material]);sides=new ga(new wi,new ia({color:0,transparent:!0,opacity:.28,depthTest:!1}));mesh=null;tiling=null;costs=[];draws=0;sidesOf=null;size=``;constructor(){let e=Eu(this.canvas,{antialias:!1,alpha:!1,depth:!1,stencil:!1});this.renderer=new Vl({canvas:this.canvas,context:e,antialias:!1,alpha:!1,depth:!1}),this.faces.frustumCulled=this.sides.frustumCulled=!1,this.sides.renderOrder=1,this.world.add(this.faces,this.sides),this.world.matrixWorldAutoUpdate=!1,this.setTheme(`light`)}get cost(){return this.costs.length?Math.min(...this.costs):0}setMesh(e){if(this.mesh=e,this.tiling=e?uu(e):null,this.costs=[],this.draws=0,this.faces.geometry.dispose(),this.faces.geometry=new wi,this.faces.visible=this.sides.visible=!1,!e)return;let{geometry:t}=this.faces,n=new Float32Array(3*e.nodeCount);for(let t=0;t<e.nodeCount;t++)n[3*t]=e.nodes[2*t],n[3*t+1]=e.nodes[2*t+1];t.setAttribute(`position`,new li(n,3)),t.setIndex(new li(this.tiling.faces,1))}setPicture(e){if(this.faces.visible=this.mesh!==null&&e!==null,this.sides.visible=this.faces.visible&&e.mesh,!this.mesh||!e)return;let{geometry:t}=this.faces;Pu(t,`value`,e.values),Pu(t,`contact`,e.contact??e.values),this.uniforms.uContact.value=+!!e.contact,Mu(this.uniforms,e.scale,e.lines),e.mesh&&this.sidesOf!==this.mesh&&(this.sides.geometry.dispose(),this.sides.geometry=new wi,this.sides.geometry.setAttribute(`position`,t.getAttribute(`position`)),this.sides.geometry.setIndex(new li(pu(this.mesh),1)),this.sidesOf=this.mesh)}setTheme(e){let{paper:t,hatch:n}=vu(e);this.renderer.setClearColor(t,1),this.uniforms.uPaper.value=_u(t).map(e=>e/255),this.uniforms.uHatch.value=_u(n).map(e=>e/255)}draw(e,t,n,r){let i=`${t} ${n} ${r}`;i!==this.size&&(this.renderer.setPixelRatio(r),this.renderer.setSize(t,n),this.size=i);let[a,o]=[t/2/e.scale,n/2/e.scale];if(Object.assign(this.camera,{left:e.x-a,right:e.x+a,bottom:e.y-o,top:e.y+o}),this.camera.updateProjectionMatrix(),this.uniforms.uRatio.value=r,this.uniforms.uAnchor.value.set((t/2-e.x*e.scale)*r,(n/2-e.y*e.scale)*r),this.tiling&&this.faces.visible){let{geometry:t}=this.faces;t.clearGroups();let n=this.tiling.side*e.scale*r<fu;for(let[r,i]of du(this.tiling,[e.x-a,e.y-o,e.x+a,e.y+o],n))t.addGroup(r,i,0)}this.renderer.render(this.world,this.camera),this.draws+=1,this.draws>1&&(this.draws<8||this.draws%60==0)&&this.time()}time(){let e=this.renderer.getContext(),t=e.fenceSync(e.SYNC_GPU_COMMANDS_COMPLETE,0);if(!t)return;e.flush();let n=performance.now(),r=()=>{e.clientWaitSync(t,0,0)===e.TIMEOUT_EXPIRED&&performance.now()-n<2e3?setTimeout(r,1):(e.deleteSync(t),this.costs=[...this.costs.slice(-2),performance.now()-n])};setTimeout(r,1)}dispose(){this.faces.geometry.dispose(),this.sides.geometry.dispose(),this.material.dispose(),this.uniforms.uBands.value?.dispose(),this.renderer.dispose(),this.renderer.forceContextLoss(),this.canvas.remove()}};function Pu(e,t,n){let r=e.getAttribute(t);if(r&&r.array.length===n.length){if(r.array===n)return;r.array=n,r.needsUpdate=!0}else e.setAttribute(t,new li(n,1))}function Z(e,t={},...n){let r=document.createElement(e);for(let[e,n]of Object.entries(t))typeof n==`function`?r.addEventListener(e,n):e===`style`?r.style.cssText=String(n):n===!0?r.setAttribute(e,``):n!==!1&&r.setAttribute(e,String(n));return r.append(...n),r}function Fu(e){let t=Z(`span`,{class:`gs-symbol`}),[,n,r,i]=/^(\w+?)_(\w+)(.*)$/.exec(e)??[null,e,``,``];return t.append(Z(`i`,{},Ru[n]??n)),r&&t.append(Z(`sub`,{},r)),i&&t.append(i),t}function Iu(e){let[,t,n,r]=/^(\w+?)_(\w+)(.*)$/.exec(e)??[null,e,``,``];return`${Ru[t]??t}${n}${r}`}function Lu(e){return e.replace(/\b[A-Za-z]+_[A-Za-z0-9]+/g,Iu)}var Ru={beta:`β`,gamma:`γ`,phi:`φ`},zu=e=>nu(e,5);function Bu(e,t){let n=e=>t&&e.case?t.get(e.case)??0:1,r=e.filter(e=>n(e)!==0),i=new Map;for(let e of r)i.set(Vu(e),[...i.get(Vu(e))??[],e]);return r.map(e=>{if(!t&&e.case)return{load:e,words:`${Hu([e],()=>1)} (1.0 ${e.case})`};let r=i.get(Vu(e));return{load:e,words:r[0]===e?Hu(r,n):``}})}function Vu({kind:e,points:t,ring:n}){return JSON.stringify([e,t??n??null])}function Hu(e,t){let n=new Map;for(let r of e)for(let[e,i,a]of r.parts)n.set(e,{value:(n.get(e)?.value??0)+t(r)*i,unit:a});let r=n.get(`q_end`);n.delete(`q_end`);let i=[...n],a=i.filter(([,{value:e}])=>zu(e)!==`0`);return(a.length>0?a:i.slice(0,1)).map(([e,{value:t,unit:n}])=>{let i=r&&zu(r.value)!==zu(t)?` to ${zu(r.value)}`:``;return`${e} = ${zu(t)}${i} ${n}`}).join(`, `)+(e.some(e=>e.varies)?` and varying`:``)}var Uu={loads:!0,columns:!0,supports:!0,zones:!0,ground:!0,output:!0,labels:!0,extremes:!0,axes:!0},Wu={left:46,bottom:26};function Gu(e,t,n){let{camera:r,width:i,height:a}=e;return[i/2+(t-r.x)*r.scale,a/2-(n-r.y)*r.scale]}var Ku=Wu.bottom+40;function qu(e,t,n,r){let{context:i}=e;i.lineJoin=i.lineCap=`round`;let a=new Ju(e);if(t&&(n.ground&&$u(e,t,a,n),n.zones&&Qu(e,t,a,n),Zu(e,t),n.output&&ed(e,t,a,n),n.loads&&td(e,t,a,n,r.factors),n.supports&&nd(e,t,a,n),n.columns&&rd(e,t,a,n)),n.extremes)for(let t of r.extremes)ad(e,t,a);a.draw(),r.section&&cd(e,r.section),r.place&&sd(e,r.place),r.pick&&od(e,r.pick)}var Ju=class{sheet;boxes=[];texts=[];constructor(e){this.sheet=e}add(e,[t,n],r,i=1,a=`left`){e&&this.texts.push({text:e,x:t,y:n,colour:r,weight:i,align:a})}draw(){let{context:e,look:t,font:n,width:r,height:i}=this.sheet;e.font=`12px ${n}`,e.textBaseline=`middle`,e.lineWidth=3.5,e.strokeStyle=t.halo;for(let{text:t,x:n,y:a,colour:o,align:s}of this.texts.sort((e,t)=>t.weight-e.weight)){if(n<-200||a<-20||n>r+200||a>i+20)continue;let c=e.measureText(t).width,l=s===`center`?n-c/2:s===`right`?n-c:n;s===`left`&&l+c>r-2&&n<r&&(l=n-c-16);let u=[l-2,a-8,l+c+2,a+8];this.boxes.some(e=>u[0]<e[2]&&e[0]<u[2]&&u[1]<e[3]&&e[1]<u[3])||(this.boxes.push(u),e.textAlign=`left`,e.strokeText(t,l,a),e.fillStyle=o,e.fillText(t,l,a))}}};function Yu(e,t,n=!0){let{context:r}=e;t.forEach(([t,n],i)=>{let[a,o]=Gu(e,t,n);i?r.lineTo(a,o):r.moveTo(a,o)}),n&&r.closePath()}function Xu(e,t,n,r,i=[],a=!0,o=0){if(!t.length)return;let{context:s,look:c}=e;s.beginPath();for(let n of t)Yu(e,n,a);o&&(s.setLineDash([]),s.lineWidth=r+o,s.strokeStyle=c.halo,s.stroke()),s.setLineDash(i),s.lineWidth=r,s.strokeStyle=n,s.stroke(),s.setLineDash([])}function Zu(e,t){let{context:n,look:r}=e;for(let{ring:i}of t.openings){n.beginPath(),Yu(e,i),n.fillStyle=r.paper,n.fill(),n.save(),n.clip();let[t,a,o,s]=dd(i);Xu(e,[[[t,a],[o,s]],[[t,s],[o,a]]],r.ink2,.8,[],!1),n.restore()}Xu(e,[t.outline,...t.openings.map(e=>e.ring)],r.ink,1.6)}function Qu(e,t,n,r){if(Xu(e,t.zones.map(e=>e.ring),e.look.ink,1.1,[7,4],!0,1.5),r.labels)for(let r of t.zones){let[t,,,i]=dd(r.ring),[a,o]=Gu(e,t,i);n.add(`t = ${nu(r.thickness*1e3)} mm`,[a+5,o+11],e.look.ink,3)}}function $u(e,t,n,r){let{context:i,look:a}=e;Xu(e,t.soil_zones.map(e=>e.ring),a.soil,1.2,[2,4]),Xu(e,t.voids.map(e=>e.ring),a.soil,1.4,[4,3],!0,1.5);for(let{name:o,x:s,y:c}of t.boreholes){let[t,l]=Gu(e,s,c);i.fillStyle=a.paper,i.strokeStyle=a.soil,i.lineWidth=1.4,i.beginPath(),i.arc(t,l,6,0,2*Math.PI),i.fill(),i.stroke(),i.fillStyle=a.soil;for(let e of[0,Math.PI])i.beginPath(),i.moveTo(t,l),i.arc(t,l,6,e,e+Math.PI/2),i.fill();r.labels&&n.add(o,[t+10,l],a.soil,2)}}function ed(e,t,n,r){let{context:i,look:a}=e;Xu(e,t.lines.map(({start:e,end:t})=>[e,t]),a.section,1.2,[12,3,2,3],!1,2);for(let n of t.strips){let[t,r]=[n.end[0]-n.start[0],n.end[1]-n.start[1]],i=Math.hypot(t,r)||1,[o,s]=[-r/i*n.width/2,t/i*n.width/2];Xu(e,[[[n.start[0]+o,n.start[1]+s],[n.end[0]+o,n.end[1]+s],[n.end[0]-o,n.end[1]-s],[n.start[0]-o,n.start[1]-s]]],a.section,1,[3,3],!0,1.5)}for(let{x:n,y:r}of t.points){let[t,o]=Gu(e,n,r);i.beginPath(),i.moveTo(t-4,o-4),i.lineTo(t+4,o+4),i.moveTo(t-4,o+4),i.lineTo(t+4,o-4);for(let[e,t]of[[4.5,a.halo],[1.7,a.section]])i.lineWidth=e,i.strokeStyle=t,i.stroke()}if(r.labels){for(let r of[...t.lines,...t.strips]){let[t,i]=Gu(e,...r.start);n.add(r.name,[t+5,i-9],a.section,2)}for(let r of t.points){let[t,i]=Gu(e,r.x,r.y);n.add(r.name,[t+7,i-8],a.section,2)}}}function td(e,t,n,r,i){let{look:a}=e;for(let{load:o,words:s}of Bu(t.loads,i))if(o.kind!==`uniform`){if(o.ring){Xu(e,[o.ring,...o.holes??[]],a.load,1.4,[5,4],!0,1.5);let[t,i,c,l]=dd(o.ring),[u,d]=Gu(e,(t+c)/2,(i+l)/2);r.labels&&n.add(Lu(s),[u,d],a.load,1.5,`center`)}else if(o.points&&o.points.length>1){Xu(e,[o.points],a.load,2.4,[],!1,2);let[t,i]=[o.points[0],o.points[1]],[c,l]=Gu(e,(t[0]+i[0])/2,(t[1]+i[1])/2);r.labels&&n.add(Lu(s),[c+6,l-10],a.load,1.5)}else if(o.points?.length){o.footprint&&Xu(e,[o.footprint],a.load,1.1,[4,3],!0,1.5);let[t,i]=Gu(e,...o.points[0]);id(e,t,i,6,a.load,!1),r.labels&&n.add(Lu(s),[t+9,i-9],a.load,1.5)}}}function nd(e,t,n,r){let{look:i}=e;for(let a of t.supports){if(a.kind===`line`)Xu(e,[a.points],i.support,4,a.elastic?[8,6]:[],!1,2.5);else{let[t,n]=Gu(e,...a.points[0]);id(e,t,n,7,i.support,!0,a.elastic)}let[t,o]=Gu(e,...a.points[0]);r.labels&&n.add(a.name,[t+10,o+9],i.support,1.2)}}function rd(e,t,n,r){let{context:i,look:a}=e;for(let o of t.columns){let[t,s]=Gu(e,o.x,o.y),[c,l,u,d]=dd(o.ring);i.beginPath(),Yu(e,o.ring),i.fillStyle=`rgb(20 24 28 / 0.55)`,i.fill(),i.lineWidth=2.6,i.strokeStyle=a.halo,i.stroke(),i.lineWidth=1.3,i.strokeStyle=a.ink,i.stroke();let f=Math.max(u-c,d-l)*e.camera.scale;r.labels&&o.name&&n.add(o.name,[t+f/2+4,s+9],a.ink,1.1)}}function id(e,t,n,r,i,a,o=!1){let{context:s,look:c}=e,l=a?1:-1;s.beginPath(),s.moveTo(t,n-l*r*.2),s.lineTo(t-r,n+l*r*1.4),s.lineTo(t+r,n+l*r*1.4),s.closePath(),s.fillStyle=o?c.paper:i,s.lineWidth=o?1.8:1.2,s.strokeStyle=o?i:c.paper,s.fill(),s.stroke()}function ad(e,t,n){let{context:r,look:i}=e,[a,o]=Gu(e,...t.point);r.beginPath(),r.arc(a,o,4,0,2*Math.PI),r.fillStyle=t.largest?i.ink:i.paper,r.lineWidth=1.6,r.fill(),r.strokeStyle=t.largest?i.paper:i.ink,r.stroke(),n.add(t.text,[a+8,o+1],i.ink,9)}function od(e,t){let{context:n,look:r}=e,[i,a]=Gu(e,...t);for(let[e,t]of[[4,r.halo],[1.5,r.accent]]){n.lineWidth=e,n.strokeStyle=t,n.beginPath(),n.arc(i,a,7,0,2*Math.PI);for(let[e,t]of[[1,0],[-1,0],[0,1],[0,-1]])n.moveTo(i+3*e,a+3*t),n.lineTo(i+12*e,a+12*t);n.stroke()}}function sd(e,t){let{context:n,look:r}=e,[i,a]=Gu(e,...t);n.beginPath(),n.arc(i,a,5,0,2*Math.PI),n.fillStyle=r.section,n.lineWidth=2,n.strokeStyle=r.paper,n.fill(),n.stroke()}function cd(e,[t,n]){let{context:r,look:i}=e,[a,o]=Gu(e,...t),[s,c]=Gu(e,...n),l=Math.hypot(s-a,c-o)||1,[u,d]=[-(c-o)/l*6,(s-a)/l*6];for(let[e,t]of[[4.5,i.halo],[2,i.section]]){r.lineWidth=e,r.strokeStyle=t,r.beginPath(),r.moveTo(a,o),r.lineTo(s,c);for(let[e,t]of[[a,o],[s,c]])r.moveTo(e-u,t-d),r.lineTo(e+u,t+d);r.stroke()}}function ld(e){let{context:t,camera:n,width:r,height:i,look:a,font:o}=e,{left:s,bottom:c}=Wu;t.fillStyle=a.paper,t.fillRect(0,0,s,i),t.fillRect(s,i-c,r-s,c),t.strokeStyle=a.ink2,t.fillStyle=a.ink2,t.lineWidth=1,t.font=`11px ${o}`,t.beginPath(),t.moveTo(s+.5,0),t.lineTo(s+.5,i-c+.5),t.lineTo(r,i-c+.5);let l=Xl(n.x+(s-r/2)/n.scale,n.x+r/2/n.scale,r/90),u=Xl(n.y+(c-i/2)/n.scale,n.y+i/2/n.scale,i/70);t.textAlign=`center`,t.textBaseline=`top`,ru(l).forEach((n,a)=>{let o=Math.round(Gu(e,l[a],0)[0])+.5;t.moveTo(o,i-c),t.lineTo(o,i-c+4),o>s+14&&o<r-34&&t.fillText(n,o,i-c+7)}),t.textAlign=`right`,t.textBaseline=`middle`,ru(u).forEach((n,r)=>{let a=Math.round(Gu(e,0,u[r])[1])+.5;t.moveTo(s-4,a),t.lineTo(s,a),a>22&&a<i-c-6&&t.fillText(n,s-7,a)}),t.stroke(),t.textAlign=`left`,t.fillText(`y [m]`,8,10),t.textAlign=`right`,t.textBaseline=`top`,t.fillText(`x [m]`,r-4,i-c+7),ud(e)}function ud(e){let{context:t,camera:n,width:r,height:i,look:a,font:o}=e,s=Jl(50/n.scale),c=s*n.scale,[l,u]=[r-12,i-Wu.bottom-10],d=`${nu(s)} m`;t.font=`11px ${o}`;let f=Math.max(c,t.measureText(d).width)+12;t.fillStyle=a.halo,t.fillRect(l-f+6,u-17,f,23),t.strokeStyle=a.ink,t.lineWidth=1.5,t.beginPath(),t.moveTo(l-c,u-4),t.lineTo(l-c,u+2),t.lineTo(l,u+2),t.lineTo(l,u-4),t.stroke(),t.fillStyle=a.ink,t.textAlign=`right`,t.textBaseline=`bottom`,t.fillText(d,l,u-3)}function dd(e){let[t,n]=[e.map(([e])=>e),e.map(([,e])=>e)];return[Math.min(...t),Math.min(...n),Math.max(...t),Math.max(...n)]}var fd=`groundslab-theme`,pd=`(prefers-color-scheme: dark)`;function md(){let e=document.documentElement.dataset.theme??yd();return e===`light`||e===`dark`?e:matchMedia(pd).matches?`dark`:`light`}function hd(e){document.documentElement.dataset.theme=e;try{localStorage.setItem(fd,e)}catch{}for(let t of vd)t(e)}function gd(e){vd.add(e);let t=()=>e(md()),n=matchMedia(pd);return n.addEventListener(`change`,t),()=>{vd.delete(e),n.removeEventListener(`change`,t)}}function _d(){let e=yd();e&&(document.documentElement.dataset.theme=e)}var vd=new Set;function yd(){try{return localStorage.getItem(fd)}catch{return null}}var bd=`system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", "Liberation Sans", "DejaVu Sans", sans-serif`,xd=4,Sd=22,Cd=30,wd=120,Td=140,Ed=class{onPick;onSection;onView;onHover;onShow;onPointer;element=document.createElement(`div`);overlay=document.createElement(`canvas`);axes=[document.createElement(`canvas`),document.createElement(`canvas`)];painter;scene=null;plan=null;what=null;picture=null;seen=null;camera={x:0,y:0,scale:40};fitted=!1;size=[0,0];tool=`pan`;theme=md();layers={...Uu};options={lines:!0,mesh:!1,contact:!0};range=`auto`;marks={pick:null,place:null,section:null,extremes:[],factors:null};sectionStart=null;pointers=new Map;pressed=null;frame=0;still=0;moving=!1;drawn=null;slow=!1;before=0;between=0;frames=0;sharp=null;resized;ended=new AbortController;constructor(e){let{element:t,overlay:n}=this;t.className=`gs-plan`,t.tabIndex=0,t.setAttribute(`role`,`application`),t.setAttribute(`aria-label`,`Plan view. Arrow keys move it, plus and minus zoom, 0 shows all.`),this.painter=this.makePainter(),n.className=`gs-overlay`,this.axes[0].className=`gs-axis-left`,this.axes[1].className=`gs-axis-bottom`,t.append(this.painter.canvas,n,...this.axes),e.append(t),this.listen(),this.resized=new ResizeObserver(()=>this.resize()),this.resized.observe(t),this.setTheme(this.theme),this.resize()}get accelerated(){return this.painter instanceof Nu}get shown(){return this.seen}setScene(e){this.scene=e,this.sharp=null,this.what=null,this.painter.setMesh(e?.mesh??null),e&&this.setPlan(e.head.plan),this.refresh()}setPlan(e){let t=this.plan===null&&e!==null,n=e!==null&&this.plan!==null&&String(e.bounds)!==String(this.plan.bounds);this.plan=e,(t||n&&this.fitted)&&this.fit(),this.request()}show(e,t){this.what={choice:e,field:t},this.refresh()}setTool(e){this.tool=e,this.sectionStart=null,this.element.dataset.tool=e}setTheme(e){this.theme=e,this.painter.setTheme(e),this.request()}setLayers(e){Object.assign(this.layers,e),this.request()}setOptions(e){Object.assign(this.options,e),this.refresh()}setRange(e){this.range=e,this.refresh()}markPick(e){this.marks.pick=e,this.request()}markSection(e){this.marks.section=e,this.request()}markPlace(e){this.marks.place=e,this.request()}fit(){let[e,t,n,r]=this.plan?.bounds??[-5,-5,5,5],[i,a]=this.size;this.camera=Dd([e,t,n,r],i,a,this.layers.axes),this.fitted=!0,this.changed()}toPlan(e,t){let[n,r]=this.size;return[this.camera.x+(e-n/2)/this.camera.scale,this.camera.y-(t-r/2)/this.camera.scale]}toPixel(e,t){let[n,r]=this.size;return[n/2+(e-this.camera.x)*this.camera.scale,r/2-(t-this.camera.y)*this.camera.scale]}get zoom(){return this.camera.scale}snapshot(e,t,n){let r=document.createElement(`canvas`);[r.width,r.height]=[Math.round(e*n),Math.round(t*n)];let i=r.getContext(`2d`),a=this.camera.scale*Math.min(e/Math.max(this.size[0],1),t/Math.max(this.size[1],1)),o=this.fitted&&this.plan?Dd(this.plan.bounds,e,t,this.layers.axes):{...this.camera,scale:a},s=this.painter;s.setTheme(`light`),s.draw(o,e,t,n),i.drawImage(s.canvas,0,0,r.width,r.height),i.scale(n,n);let c={context:i,camera:o,width:e,height:t,look:vu(`light`),font:bd};return qu(c,this.plan,this.layers,this.marks),this.layers.axes&&ld(c),s.setTheme(this.theme),this.draw(),r}dispose(){this.ended.abort(),this.resized.disconnect(),cancelAnimationFrame(this.frame),clearTimeout(this.still),this.painter.dispose(),this.element.remove()}refresh(){let{scene:e,what:t}=this;if(this.picture=null,this.seen=null,this.marks.extremes=[],this.marks.factors=null,e&&t){let n=p(e,t.field),r=C(e,t.choice,t.field),i=e.head.fields.some(e=>e.name===`contact`)?C(e,t.choice,s):null,a=i!==null&&E(i).max>0,o=Ad(e,t.choice,n,this.range);this.picture={values:r,contact:this.options.contact&&a?i:null,scale:o,lines:this.options.lines,mesh:this.options.mesh},this.seen={choice:t.choice,field:n,scale:o,lifted:a},this.marks.extremes=Od(d(e,t.choice,t.field));let c=v(t.choice)?null:e.head.combinations[t.choice]?.factors;c?.length&&(this.marks.factors=new Map(c))}this.painter.setPicture(this.picture),this.sharp=null,this.onShow?.(this.seen),this.request()}resize(){let{clientWidth:e,clientHeight:t}=this.element;e&&t&&(this.size=[e,t],this.fitted?this.fit():this.changed())}changed(){this.request(),this.onView?.()}request(){this.frame||=requestAnimationFrame(()=>{this.frame=0,this.draw()})}movingNow(){this.moving=!0,clearTimeout(this.still),this.still=window.setTimeout(()=>{this.moving=!1,this.request()},Td)}draw(){let[e,t]=this.size;if(!e||!t)return;this.watch();let n=Math.min(window.devicePixelRatio||1,2);this.paint(e,t,n);let{overlay:r,camera:i,drawn:a}=this,o=performance.now();if(this.moving&&this.slow&&a&&a.camera.scale===i.scale&&o-a.when<wd){r.style.transform=`translate(${(a.camera.x-i.x)*i.scale}px, ${(i.y-a.camera.y)*i.scale}px)`;return}let s={camera:i,width:e,height:t,look:vu(this.theme),font:bd};r.style.transform=``,qu({...s,context:kd(r,e,t,n)},this.plan,this.layers,this.marks),this.drawn={camera:{...i},when:o};let[c,l]=this.axes;if(c.hidden=l.hidden=!this.layers.axes,!this.layers.axes)return;ld({...s,context:kd(c,Wu.left+2,t,n)});let u=kd(l,e,Ku,n);u.translate(0,Ku-t),ld({...s,context:u})}watch(){let e=performance.now();this.painter.cost>Sd&&(this.slow=!0),this.moving&&this.before&&e-this.before<500&&(this.between=this.between?.8*this.between+.2*(e-this.before):e-this.before,this.frames+=1,this.frames>8&&this.between>Cd&&(this.slow=!0)),this.before=this.moving?e:0}paint(e,t,n){let{painter:r,camera:i,sharp:a}=this,o=performance.now();if(this.moving&&a&&this.slow){let n=i.scale/a.camera.scale,[s,c]=[(a.camera.x-i.x)*i.scale,(i.y-a.camera.y)*i.scale];if(n>.6&&n<2&&Math.abs(s)<e/3&&Math.abs(c)<t/3||o-a.when<4*r.cost){r.canvas.style.transform=`translate(${s}px, ${c}px) scale(${n})`;return}}r.draw(i,e,t,n),r.canvas.style.transform=``,this.sharp={camera:{...i},when:o},this.element.dataset.cost=r.cost.toFixed(1)}move(e,t){this.camera.x-=e/this.camera.scale,this.camera.y+=t/this.camera.scale,this.fitted=!1,this.movingNow(),this.changed()}zoomAt([e,t],n){let[r,i]=this.toPlan(e,t),[a,o,s,c]=this.plan?.bounds??[-5,-5,5,5],l=Math.min(...this.size)/Math.max(s-a,c-o,1e-6);this.camera.scale=Math.min(Math.max(this.camera.scale*n,l/20),l*2e3);let[u,d]=this.toPlan(e,t);this.camera.x+=r-u,this.camera.y+=i-d,this.fitted=!1,this.movingNow(),this.changed()}makePainter(){try{let e=new Nu;return e.canvas.addEventListener(`webglcontextlost`,()=>{this.painter!==e||this.ended.signal.aborted||(this.painter=new wu,e.canvas.replaceWith(this.painter.canvas),this.painter.setTheme(this.theme),this.painter.setMesh(this.scene?.mesh??null),this.painter.setPicture(this.picture),this.sharp=null,this.request())}),e}catch{return new wu}}listen(){let{element:e}=this,t={signal:this.ended.signal},n=t=>{let n=e.getBoundingClientRect();return[t.clientX-n.left,t.clientY-n.top]};e.addEventListener(`pointerdown`,t=>{let r=n(t);this.onPointer?.(t,...this.toPlan(...r))||t.button>1||(e.setPointerCapture(t.pointerId),this.pointers.set(t.pointerId,r),this.pressed={at:r,moved:this.pointers.size>1})},t),e.addEventListener(`pointermove`,e=>{let t=n(e);if(this.onPointer?.(e,...this.toPlan(...t)))return;let r=this.pointers.get(e.pointerId);if(!r){this.hover(this.toPlan(...t),e.shiftKey);return}let i=[...this.pointers].filter(([t])=>t!==e.pointerId).map(([,e])=>e);this.pointers.set(e.pointerId,t);let a=i[0];if(a){let e=e=>Math.max(Math.hypot(e[0]-a[0],e[1]-a[1]),1);this.move((t[0]-r[0])/2,(t[1]-r[1])/2),this.zoomAt([(t[0]+a[0])/2,(t[1]+a[1])/2],e(t)/e(r));return}let{pressed:o}=this;o&&!o.moved&&Math.hypot(t[0]-o.at[0],t[1]-o.at[1])<xd||(o&&!o.moved?(o.moved=!0,this.move(t[0]-o.at[0],t[1]-o.at[1])):this.move(t[0]-r[0],t[1]-r[1]))},t);let r=e=>{let t=n(e);if(this.onPointer?.(e,...this.toPlan(...t))||!this.pointers.delete(e.pointerId))return;let{pressed:r}=this;this.pointers.size||(this.pressed=null),e.type===`pointerup`&&r&&!r.moved&&e.button===0&&this.click(this.toPlan(...t),e.shiftKey)};e.addEventListener(`pointerup`,r,t),e.addEventListener(`pointercancel`,r,t),e.addEventListener(`pointerleave`,()=>this.hover(null),t),e.addEventListener(`wheel`,e=>{e.preventDefault();let t=e.deltaMode===1?16:e.deltaMode===2?160:1;this.zoomAt(n(e),Math.exp(-Math.min(Math.max(e.deltaY*t,-300),300)*(e.ctrlKey?.01:.0015)))},{...t,passive:!1}),e.addEventListener(`dblclick`,()=>{this.tool===`pan`&&this.fit()},t),e.addEventListener(`keydown`,e=>{this.key(e)&&e.preventDefault()},t)}rounded([e,t],n){let r=Math.max(0,Math.ceil(Math.log10(this.camera.scale))),[i,a]=[Number(e.toFixed(r)),Number(t.toFixed(r))],{sectionStart:o}=this;return!n||!o?[i,a]:Math.abs(i-o[0])>Math.abs(a-o[1])?[i,o[1]]:[o[0],a]}hover(e,t=!1){this.sectionStart&&e&&(this.marks.section=[this.sectionStart,this.rounded(e,t)],this.request()),this.onHover?.(e)}click(e,t){let n=this.rounded(e,t);if(this.tool===`pick`)this.marks.pick=n,this.request(),this.onPick?.(...n);else if(this.tool===`section`){if(!this.sectionStart)this.sectionStart=n,this.marks.section=[n,n];else{let e=this.sectionStart;this.sectionStart=null,this.marks.section=[e,n],this.onSection?.(e,n)}this.request()}}key(e){if(e.ctrlKey||e.metaKey||e.altKey)return!1;let t=e.shiftKey?200:50,n=[this.size[0]/2,this.size[1]/2];switch(e.key){case`ArrowLeft`:return this.move(t,0),!0;case`ArrowRight`:return this.move(-t,0),!0;case`ArrowUp`:return this.move(0,t),!0;case`ArrowDown`:return this.move(0,-t),!0;case`+`:case`=`:return this.zoomAt(n,1.25),!0;case`-`:return this.zoomAt(n,.8),!0;case`0`:return this.fit(),!0;case`Escape`:return this.sectionStart?(this.sectionStart=null,this.markSection(null),!0):!1;default:return!1}}};function Dd([e,t,n,r],i,a,o){let[s,c]=o?[Wu.left,Wu.bottom]:[0,0],l=o?14:0,u=Math.max(1e-6,Math.min((i-s-44)/Math.max(n-e,1e-6),(a-c-l-44)/Math.max(r-t,1e-6)));return{x:(e+n)/2-s/2/u,y:(t+r)/2-(c+l)/2/u,scale:u}}function Od({min:e,max:t}){let n=([e,t,n],r,i)=>({point:[t,n],text:`${r} ${tu(e)}`,largest:i}),r=1e-6*Math.max(Math.abs(e[0]),Math.abs(t[0]));return[...t[0]-e[0]>r&&Math.abs(t[0])>r?[n(t,`max`,!0)]:[],...t[0]-e[0]>r&&Math.abs(e[0])>r?[n(e,`min`,!1)]:[]]}function kd(e,t,n,r){let[i,a]=[Math.round(t*r),Math.round(n*r)],o=e.getContext(`2d`);return(e.width!==i||e.height!==a)&&([e.width,e.height]=[i,a]),o.setTransform(1,0,0,1,0,0),o.clearRect(0,0,i,a),o.scale(r,r),o}function Ad(e,t,n,r){let i=d(e,t,n.name),[a,o]=[i.min[0],i.max[0]];if(typeof r!=`string`)return{...Ql(r[0],r[1],n.signed,r),min:a,max:o};let[s,c]=[a,o];if(r===`common`&&y(e,`largest`).length>1){let t=d(e,`largest`,n.name);[s,c]=[d(e,`smallest`,n.name).min[0],t.max[0]]}return n.signed||(s=Math.min(s,0)),{...Ql(s,c,n.signed),min:a,max:o}}var jd={type:`change`},Md={type:`start`},Nd={type:`end`},Pd=new Fi,Fd=new Oi,Id=Math.cos(70*Cn.DEG2RAD),Ld=new J,Rd=2*Math.PI,zd={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Bd=1e-6,Vd=class extends Oo{constructor(e,t=null){super(e,t),this.state=zd.NONE,this.target=new J,this.cursor=new J,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:`ArrowLeft`,UP:`ArrowUp`,RIGHT:`ArrowRight`,BOTTOM:`ArrowDown`},this.mouseButtons={LEFT:pe.ROTATE,MIDDLE:pe.DOLLY,RIGHT:pe.PAN},this.touches={ONE:me.ROTATE,TWO:me.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle=`auto`,this._domElementKeyEvents=null,this._lastPosition=new J,this._lastQuaternion=new wn,this._lastTargetPosition=new J,this._quat=new wn().setFromUnitVectors(e.up,new J(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Do,this._sphericalDelta=new Do,this._scale=1,this._panOffset=new J,this._rotateStart=new q,this._rotateEnd=new q,this._rotateDelta=new q,this._panStart=new q,this._panEnd=new q,this._panDelta=new q,this._dollyStart=new q,this._dollyEnd=new q,this._dollyDelta=new q,this._dollyDirection=new J,this._mouse=new q,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=Ud.bind(this),this._onPointerDown=Hd.bind(this),this._onPointerUp=Wd.bind(this),this._onContextMenu=Zd.bind(this),this._onMouseWheel=qd.bind(this),this._onKeyDown=Jd.bind(this),this._onTouchStart=Yd.bind(this),this._onTouchMove=Xd.bind(this),this._onMouseDown=Gd.bind(this),this._onMouseMove=Kd.bind(this),this._interceptControlDown=Qd.bind(this),this._interceptControlUp=$d.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e===`grab`?this.domElement.style.cursor=`grab`:this.domElement.style.cursor=`auto`}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener(`pointerdown`,this._onPointerDown),this.domElement.addEventListener(`pointercancel`,this._onPointerUp),this.domElement.addEventListener(`contextmenu`,this._onContextMenu),this.domElement.addEventListener(`wheel`,this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener(`keydown`,this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction=`none`}disconnect(){this.state=zd.NONE,this.domElement.removeEventListener(`pointerdown`,this._onPointerDown),this.domElement.ownerDocument.removeEventListener(`pointermove`,this._onPointerMove),this.domElement.ownerDocument.removeEventListener(`pointerup`,this._onPointerUp),this.domElement.removeEventListener(`pointercancel`,this._onPointerUp),this.domElement.removeEventListener(`wheel`,this._onMouseWheel),this.domElement.removeEventListener(`contextmenu`,this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener(`keydown`,this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener(`keyup`,this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction=``,this.domElement.style.cursor=`auto`}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener(`keydown`,this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener(`keydown`,this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(jd),this.update(),this.state=zd.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;Ld.copy(t).sub(this.target),Ld.applyQuaternion(this._quat),this._spherical.setFromVector3(Ld),this.autoRotate&&this.state===zd.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,r=this.maxAzimuthAngle;isFinite(n)&&isFinite(r)&&(n<-Math.PI?n+=Rd:n>Math.PI&&(n-=Rd),r<-Math.PI?r+=Rd:r>Math.PI&&(r-=Rd),n<=r?this._spherical.theta=Math.max(n,Math.min(r,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+r)/2?Math.max(n,this._spherical.theta):Math.min(r,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let i=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let e=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),i=e!=this._spherical.radius}if(Ld.setFromSpherical(this._spherical),Ld.applyQuaternion(this._quatInverse),t.copy(this.target).add(Ld),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let e=null;if(this.object.isPerspectiveCamera){let t=Ld.length();e=this._clampDistance(t*this._scale);let n=t-e;this.object.position.addScaledVector(this._dollyDirection,n),this.object.updateMatrixWorld(),i=!!n}else if(this.object.isOrthographicCamera){let t=new J(this._mouse.x,this._mouse.y,0);t.unproject(this.object);let n=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),i=n!==this.object.zoom;let r=new J(this._mouse.x,this._mouse.y,0);r.unproject(this.object),this.object.position.sub(r).add(t),this.object.updateMatrixWorld(),e=Ld.length()}else console.warn(`WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled.`),this.zoomToCursor=!1;e!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(e).add(this.object.position):(Pd.origin.copy(this.object.position),Pd.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Pd.direction))<Id?this.object.lookAt(this.target):(Fd.setFromNormalAndCoplanarPoint(this.object.up,this.target),Pd.intersectPlane(Fd,this.target))))}else if(this.object.isOrthographicCamera){let e=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),e!==this.object.zoom&&(this.object.updateProjectionMatrix(),i=!0)}return this._scale=1,this._performCursorZoom=!1,i||this._lastPosition.distanceToSquared(this.object.position)>Bd||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Bd||this._lastTargetPosition.distanceToSquared(this.target)>Bd?(this.dispatchEvent(jd),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e===null?Rd/60/60*this.autoRotateSpeed:Rd/60*this.autoRotateSpeed*e}_getZoomScale(e){let t=Math.abs(e*.01);return .95**(this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){Ld.setFromMatrixColumn(t,0),Ld.multiplyScalar(-e),this._panOffset.add(Ld)}_panUp(e,t){this.screenSpacePanning===!0?Ld.setFromMatrixColumn(t,1):(Ld.setFromMatrixColumn(t,0),Ld.crossVectors(this.object.up,Ld)),Ld.multiplyScalar(e),this._panOffset.add(Ld)}_pan(e,t){let n=this.domElement;if(this.object.isPerspectiveCamera){let r=this.object.position;Ld.copy(r).sub(this.target);let i=Ld.length();i*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*i/n.clientHeight,this.object.matrix),this._panUp(2*t*i/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn(`WARNING: OrbitControls.js encountered an unknown camera type - pan disabled.`),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn(`WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled.`),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn(`WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled.`),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),r=e-n.left,i=t-n.top,a=n.width,o=n.height;this._mouse.x=r/a*2-1,this._mouse.y=-(i/o)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Rd*this._rotateDelta.x/t.clientHeight),this._rotateUp(Rd*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(Rd*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-Rd*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(Rd*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-Rd*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),r=.5*(e.pageY+t.y);this._rotateStart.set(n,r)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),r=.5*(e.pageY+t.y);this._panStart.set(n,r)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,r=e.pageY-t.y,i=Math.sqrt(n*n+r*r);this._dollyStart.set(0,i)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),r=.5*(e.pageY+t.y);this._rotateEnd.set(n,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Rd*this._rotateDelta.x/t.clientHeight),this._rotateUp(Rd*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),r=.5*(e.pageY+t.y);this._panEnd.set(n,r)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,r=e.pageY-t.y,i=Math.sqrt(n*n+r*r);this._dollyEnd.set(0,i),this._dollyDelta.set(0,(this._dollyEnd.y/this._dollyStart.y)**+this.zoomSpeed),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let a=(e.pageX+t.x)*.5,o=(e.pageY+t.y)*.5;this._updateZoomParameters(a,o)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new q,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,n={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100}return e.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function Hd(e){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(e.pointerId),this.domElement.ownerDocument.addEventListener(`pointermove`,this._onPointerMove),this.domElement.ownerDocument.addEventListener(`pointerup`,this._onPointerUp)),this._isTrackingPointer(e)||(this._addPointer(e),e.pointerType===`touch`?this._onTouchStart(e):this._onMouseDown(e),this._cursorStyle===`grab`&&(this.domElement.style.cursor=`grabbing`)))}function Ud(e){this.enabled!==!1&&(e.pointerType===`touch`?this._onTouchMove(e):this._onMouseMove(e))}function Wd(e){switch(this._removePointer(e),this._pointers.length){case 0:this.domElement.releasePointerCapture(e.pointerId),this.domElement.ownerDocument.removeEventListener(`pointermove`,this._onPointerMove),this.domElement.ownerDocument.removeEventListener(`pointerup`,this._onPointerUp),this.dispatchEvent(Nd),this.state=zd.NONE,this._cursorStyle===`grab`&&(this.domElement.style.cursor=`grab`);break;case 1:let t=this._pointers[0],n=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:n.x,pageY:n.y})}}function Gd(e){let t;switch(e.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case pe.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(e),this.state=zd.DOLLY;break;case pe.ROTATE:if(e.ctrlKey||e.metaKey||e.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(e),this.state=zd.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(e),this.state=zd.ROTATE}break;case pe.PAN:if(e.ctrlKey||e.metaKey||e.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(e),this.state=zd.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(e),this.state=zd.PAN}break;default:this.state=zd.NONE}this.state!==zd.NONE&&this.dispatchEvent(Md)}function Kd(e){switch(this.state){case zd.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(e);break;case zd.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(e);break;case zd.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(e)}}function qd(e){this.enabled!==!1&&this.enableZoom!==!1&&this.state===zd.NONE&&(e.preventDefault(),this.dispatchEvent(Md),this._handleMouseWheel(this._customWheelEvent(e)),this.dispatchEvent(Nd))}function Jd(e){this.enabled!==!1&&this._handleKeyDown(e)}function Yd(e){switch(this._trackPointer(e),this._pointers.length){case 1:switch(this.touches.ONE){case me.ROTATE:if(this.enableRotate===!1){this.state=zd.NONE;break}this._handleTouchStartRotate(e),this.state=zd.TOUCH_ROTATE;break;case me.PAN:if(this.enablePan===!1){this.state=zd.NONE;break}this._handleTouchStartPan(e),this.state=zd.TOUCH_PAN;break;default:this.state=zd.NONE}break;case 2:switch(this.touches.TWO){case me.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(e),this.state=zd.TOUCH_DOLLY_PAN;break;case me.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(e),this.state=zd.TOUCH_DOLLY_ROTATE;break;default:this.state=zd.NONE}break;default:this.state=zd.NONE}this.state!==zd.NONE&&this.dispatchEvent(Md)}function Xd(e){switch(this._trackPointer(e),this.state){case zd.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(e),this.update();break;case zd.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(e),this.update();break;case zd.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(e),this.update();break;case zd.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(e),this.update();break;default:this.state=zd.NONE}}function Zd(e){this.enabled!==!1&&e.preventDefault()}function Qd(e){e.key===`Control`&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener(`keyup`,this._interceptControlUp,{passive:!0,capture:!0}))}function $d(e){e.key===`Control`&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener(`keyup`,this._interceptControlUp,{passive:!0,capture:!0}))}var ef=new J(-.45,-.35,.82).normalize(),tf=.5,nf=`
in vec3 position;
in float settlement;
uniform mat4 projectionMatrix;
uniform mat4 modelViewMatrix;
uniform float uTimes;`,rf=`${nf}
in float value;
centroid out float vValue;
out vec3 vPlace;
void main() {
  vValue = value;
  vec4 place = modelViewMatrix * vec4(position.xy, -settlement * uTimes, 1.0);
  vPlace = place.xyz;
  gl_Position = projectionMatrix * place;
}`,af=`
precision highp float;
centroid in float vValue;
in vec3 vPlace;
uniform vec3 uSun;
out vec4 result;
${ku}
void main() {
  vec3 normal = normalize(cross(dFdx(vPlace), dFdy(vPlace)));
  float light = ${tf} + 0.5 * abs(dot(normal, uSun));
  result = vec4(banded(vValue) * light, 1.0);
}`,of=`${nf}
void main() {
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position.xy, -settlement * uTimes, 1.0);
  gl_Position.z -= 1e-4 * gl_Position.w;
}`,sf=`
precision highp float;
uniform vec3 uInk;
out vec4 result;
void main() { result = vec4(uInk, 1.0); }`;function cf(e){let t=mu(e),n=new Uint32Array(t.length/3*4);for(let e=0;e<t.length/3;e++)n.set([t[3*e],t[3*e+1],t[3*e+1],t[3*e+2]],4*e);return n}var lf=class{canvas=document.createElement(`canvas`);renderer;world=new Ar;uniforms={...ju(),uTimes:{value:1},uSun:{value:new J},uInk:{value:[0,0,0]}};faces;edges;flat=new ga(new wi,new ia);columns=new ga(new wi,new ia);fine=0;size=``;constructor(){let e=Eu(this.canvas,{antialias:!0,alpha:!1,depth:!0});this.renderer=new Vl({canvas:this.canvas,context:e});let t={glslVersion:It,uniforms:this.uniforms,side:2};this.faces=new Ji(new wi,new Ma({...t,vertexShader:rf,fragmentShader:af})),this.edges=new ga(new wi,new Ma({...t,vertexShader:of,fragmentShader:sf}));for(let e of this.parts())e.frustumCulled=!1,e.visible=!1,this.world.add(e)}setMesh(e,t){for(let e of this.parts())e.geometry.dispose(),e.geometry=new wi,e.visible=!1;if(!e||!t)return;let n=new Float32Array(3*e.nodeCount);for(let t=0;t<e.nodeCount;t++)n[3*t]=e.nodes[2*t],n[3*t+1]=e.nodes[2*t+1];let r=new li(n,3);this.faces.geometry.setAttribute(`position`,r),this.faces.geometry.setIndex(new li(t.faces,1)),this.edges.geometry.setAttribute(`position`,r),this.edges.geometry.setIndex(new li(cf(e),1)),this.fine=24*e.elementCount}setPicture(e){if(this.faces.visible=this.edges.visible=e!==null,!e)return;let t=new li(e.settlement,1);this.faces.geometry.setAttribute(`settlement`,t),this.edges.geometry.setAttribute(`settlement`,t),this.faces.geometry.setAttribute(`value`,new li(e.values,1)),Mu(this.uniforms,e.scale,!0)}setLines(e,t){for(let[n,r]of[[this.flat,e],[this.columns,t]])n.geometry.dispose(),n.geometry=new wi().setAttribute(`position`,new li(r,3)),n.visible=r.length>0}setTheme(e){let{paper:t,ink:n,ink2:r}=vu(e);this.renderer.setClearColor(t,1),this.uniforms.uInk.value=_u(n).map(e=>e/255),this.flat.material.color.set(r),this.columns.material.color.set(n)}draw(e,t,n,r,i,a){let o=`${n} ${r} ${i}`;o!==this.size&&(this.size=o,this.renderer.setPixelRatio(i),this.renderer.setSize(n,r,!1)),this.uniforms.uRatio.value=i,this.uniforms.uTimes.value=t,this.uniforms.uSun.value.copy(ef).transformDirection(e.matrixWorldInverse);let{geometry:s}=this.faces;a?s.setDrawRange(this.fine,1/0):s.setDrawRange(0,this.fine),this.renderer.render(this.world,e)}dispose(){for(let e of this.parts())e.geometry.dispose(),e.material.dispose();this.uniforms.uBands.value?.dispose(),this.renderer.dispose(),this.renderer.forceContextLoss(),this.canvas.remove()}parts(){return[this.faces,this.edges,this.flat,this.columns]}},uf=class{canvas=document.createElement(`canvas`);context=this.canvas.getContext(`2d`,{willReadFrequently:!0});mesh=null;tiling=null;edges=new Uint32Array;picture=null;flat=new Float32Array;columns=new Float32Array;look=vu(`light`);pixels=new ImageData(1,1);depth=new Float32Array;bands=new Uint8Array;setMesh(e,t){this.mesh=e,this.tiling=t,this.edges=e?cf(e):new Uint32Array,this.picture=null,this.setLines(new Float32Array,new Float32Array)}setPicture(e){this.picture=e}setLines(e,t){this.flat=e,this.columns=t}setTheme(e){this.look=vu(e)}draw(e,t,n,r,i,a){let[o,s]=[Math.max(1,Math.round(n*i)),Math.max(1,Math.round(r*i))];(this.canvas.width!==o||this.canvas.height!==s)&&([this.canvas.width,this.canvas.height]=[o,s],this.pixels=new ImageData(o,s),this.depth=new Float32Array(o*s),this.bands=new Uint8Array(o*s));let{mesh:c,tiling:l,picture:u,look:d}=this,[f,p,m]=_u(d.paper);new Uint32Array(this.pixels.data.buffer).fill(255<<24|m<<16|p<<8|f),this.depth.fill(1),this.bands.fill(255);let h=e.projectionMatrix.clone().multiply(e.matrixWorldInverse).elements;if(c&&l&&u){let{nodes:e,nodeCount:n}=c,r=new Float32Array(3*n);for(let i=0;i<n;i++)df(h,e[2*i],e[2*i+1],-u.settlement[i]*t,o,s,r,3*i);let f=24*c.elementCount;this.fill(l.faces,a?f:0,a?l.faces.length:f,r,t,o,s),this.drawBandLines(o,s);let p=_u(d.ink);for(let e=0;e<this.edges.length;e+=2){let[t,n]=[3*this.edges[e],3*this.edges[e+1]];this.line(r[t],r[t+1],r[t+2],r[n],r[n+1],r[n+2],p,i,o,s)}}let g=new Float32Array(6);for(let[e,t]of[[this.flat,_u(d.ink2)],[this.columns,_u(d.ink)]])for(let n=0;n+5<e.length;n+=6)df(h,e[n],e[n+1],e[n+2],o,s,g,0),df(h,e[n+3],e[n+4],e[n+5],o,s,g,3),this.line(g[0],g[1],g[2],g[3],g[4],g[5],t,i,o,s);this.context.putImageData(this.pixels,0,0)}dispose(){this.canvas.remove()}fill(e,t,n,r,i,a,o){let{nodes:s}=this.mesh,{values:c,settlement:l,scale:u}=this.picture,{depth:d,bands:f}=this,{data:p}=this.pixels,m=u.colours.length;for(let h=t;h<n;h+=3){let t=e[h],n=e[h+1],g=e[h+2],_=r[3*t],v=r[3*t+1],y=r[3*t+2],b=r[3*n],x=r[3*n+1],S=r[3*n+2],C=r[3*g],w=r[3*g+1],T=r[3*g+2];if(!(y>-1&&S>-1&&T>-1&&y<1&&S<1&&T<1))continue;let E=Math.max(0,Math.ceil(Math.min(v,x,w)-.5)),D=Math.min(o-1,Math.floor(Math.max(v,x,w)-.5));if(E>D||Math.max(_,b,C)<0||Math.min(_,b,C)>a)continue;let O=(b-_)*(w-v)-(C-_)*(x-v);if(O===0)continue;let k=S-y,A=T-y,j=(k*(w-v)-A*(x-v))/O,M=(A*(b-_)-k*(C-_))/O,N=c[n]-c[t],ee=c[g]-c[t],te=(N*(w-v)-ee*(x-v))/O,ne=(ee*(b-_)-N*(C-_))/O,re=this.light(s,l,i,t,n,g);for(let e=E;e<=D;e++){let n=e+.5,r=1/0,i=-1/0;for(let e=0;e<3;e++){let t=e===0?_:e===1?b:C,a=e===0?v:e===1?x:w,o=e===0?b:e===1?C:_,s=e===0?x:e===1?w:v;if(a<n==s<n)continue;let c=a<s?t+(n-a)/(s-a)*(o-t):o+(n-s)/(a-s)*(t-o);c<r&&(r=c),c>i&&(i=c)}let o=Math.max(0,Math.ceil(r-.5)),s=Math.min(a-1,Math.ceil(i-.5)-1);for(let r=o;r<=s;r++){let i=e*a+r,o=y+j*(r+.5-_)+M*(n-v);if(o>=d[i])continue;d[i]=o;let s=eu(u,c[t]+te*(r+.5-_)+ne*(n-v));f[i]=s<0?253:s===m?254:s;let l=s<0?u.under:s===m?u.over:u.colours[s];p[4*i]=l[0]*re,p[4*i+1]=l[1]*re,p[4*i+2]=l[2]*re}}}}light(e,t,n,r,i,a){let o=e[2*i]-e[2*r],s=e[2*i+1]-e[2*r+1],c=(t[r]-t[i])*n,l=e[2*a]-e[2*r],u=e[2*a+1]-e[2*r+1],d=(t[r]-t[a])*n,f=s*d-c*u,p=c*l-o*d,m=o*u-s*l,h=Math.sqrt(f*f+p*p+m*m)||1;return tf+.5*(Math.abs(f*ef.x+p*ef.y+m*ef.z)/h)}drawBandLines(e,t){let{bands:n}=this,{data:r}=this.pixels;for(let i=0,a=0;i<t;i++)for(let o=0;o<e;o++,a++){let s=n[a];if(s>=253)continue;let c=o+1<e?n[a+1]:s,l=i+1<t?n[a+e]:s;(c===s||c>=253)&&(l===s||l>=253)||(r[4*a]*=.66,r[4*a+1]*=.66,r[4*a+2]*=.66)}}line(e,t,n,r,i,a,[o,s,c],l,u,d){if(!(Math.abs(n)<1&&Math.abs(a)<1))return;let f=Math.min(2e4,Math.ceil(Math.max(Math.abs(r-e),Math.abs(i-t))))||1,p=Math.max(1,Math.round(l));for(let l=0;l<=f;l++){let m=l/f,h=Math.floor(e+m*(r-e)),g=Math.floor(t+m*(i-t)),_=n+m*(a-n)-1e-4;for(let e=0;e<p;e++)for(let t=0;t<p;t++){if(h+t<0||g+e<0||h+t>=u||g+e>=d)continue;let n=(g+e)*u+h+t;_>this.depth[n]||(this.pixels.data[4*n]=o,this.pixels.data[4*n+1]=s,this.pixels.data[4*n+2]=c)}}}};function df(e,t,n,r,i,a,o,s){let c=e[3]*t+e[7]*n+e[11]*r+e[15];o[s]=((e[0]*t+e[4]*n+e[8]*r+e[12])/c+1)*.5*i,o[s+1]=(1-(e[1]*t+e[5]*n+e[9]*r+e[13])/c)*.5*a,o[s+2]=c>0?(e[2]*t+e[6]*n+e[10]*r+e[14])/c:2}var ff=32,pf=class{onShow;element=Z(`div`,{class:`gs-space`,tabindex:0,role:`application`,"aria-label":`View in space. Drag or arrow keys turn it, the wheel or plus and minus zoom, 0 shows all.`});slider=Z(`input`,{type:`range`,min:0,max:100,value:50,"aria-label":`Enlargement of the settlement`});times=Z(`output`,{});camera=new co(ff,1,.1,1e3);stage=Z(`div`,{class:`gs-space-stage`});controls;painter;scene=null;tiling=null;what=null;range=`auto`;theme=md();base=1;enlarged=1;depth=0;feet=[];fitted=!1;frame=0;resized;constructor(e){this.painter=this.makePainter(),this.stage.append(this.painter.canvas),this.element.append(this.stage,Z(`label`,{class:`gs-space-times`},`settlement enlarged`,this.slider,this.times)),e.append(this.element),this.camera.up.set(0,0,1),this.controls=new Vd(this.camera,this.stage),this.controls.addEventListener(`change`,()=>this.request()),this.controls.addEventListener(`start`,()=>{this.fitted=!1}),this.slider.addEventListener(`input`,()=>this.enlarge()),this.element.addEventListener(`keydown`,e=>{this.key(e)&&e.preventDefault()}),this.resized=new ResizeObserver(()=>this.fitted?this.fit():this.request()),this.resized.observe(this.element),this.painter.setTheme(this.theme)}get accelerated(){return this.painter instanceof lf}get enlargement(){return this.enlarged}setScene(e){this.scene=e,this.what=null,this.tiling=e?uu(e.mesh):null,this.painter.setMesh(e?.mesh??null,this.tiling),this.feet=e?e.head.plan.columns.map(({x:t,y:n})=>mf(e,t,n)):[],this.fit()}show(e,t){this.what={choice:e,field:t};let{scene:n}=this;if(!n)return;let r=p(n,t),i=Ad(n,e,r,this.range);this.painter.setPicture({settlement:C(n,e,`settlement`),values:C(n,e,t),scale:i});let a=d(n,e,`settlement`),o=Math.max(Math.abs(a.min[0]),Math.abs(a.max[0]),1e-9)/1e3;this.base=Jl(.06*this.extent()/o),this.depth=(a.min[0]+a.max[0])/2,this.enlarge(),this.onShow?.({choice:e,field:r,scale:i,lifted:!1})}setRange(e){this.range=e,this.what&&this.show(this.what.choice,this.what.field)}setTheme(e){this.theme=e,this.painter.setTheme(e),this.request()}fit(){let{scene:e,camera:t,controls:n}=this;if(this.request(),!e)return;let[r,i,a,o]=e.head.plan.bounds,{clientWidth:s,clientHeight:c}=this.element,l=Math.tan(ff*Math.PI/360)*Math.min(1,(s||1)/(c||1)/1.25),u=.5*Math.hypot(a-r,o-i)*.86/l,d=new J((r+a)/2,(i+o)/2,-this.depth*this.enlarged/1e3);n.target.copy(d),t.position.copy(d).addScaledVector(new J(-.42,-.78,.62).normalize(),u),t.near=u/100,t.far=u*20,t.updateProjectionMatrix(),n.update(),this.fitted=!0}snapshot(e,t,n){let r=document.createElement(`canvas`);return[r.width,r.height]=[Math.round(e*n),Math.round(t*n)],this.painter.setTheme(`light`),this.draw(e,t,n),r.getContext(`2d`).drawImage(this.painter.canvas,0,0,r.width,r.height),this.painter.setTheme(this.theme),this.draw(),r}dispose(){this.resized.disconnect(),cancelAnimationFrame(this.frame),this.controls.dispose(),this.painter.dispose(),this.element.remove()}makePainter(){try{let e=new lf;return e.canvas.addEventListener(`webglcontextlost`,()=>{this.painter===e&&this.element.isConnected&&(this.painter=new uf,e.canvas.replaceWith(this.painter.canvas),this.painter.setTheme(this.theme),this.painter.setMesh(this.scene?.mesh??null,this.tiling),this.what&&this.show(this.what.choice,this.what.field))}),e}catch{return new uf}}extent(){let[e,t,n,r]=this.scene?.head.plan.bounds??[0,0,1,1];return Math.max(n-e,r-t)}enlarge(){let e=Number(this.slider.value);this.enlarged=e===0?0:this.base*10**((e-50)/50),this.times.textContent=`${nu(this.enlarged,2)}\u00d7`,this.scene&&this.what&&(this.painter.setLines(this.flatLines(),this.columnLines()),this.fitted&&this.fit(),this.request())}flatLines(){let{plan:e}=this.scene.head,t=[e.outline,...e.openings.map(e=>e.ring)];return Float32Array.from(t.flatMap(e=>e.flatMap(([t,n],r)=>{let[i,a]=e[(r+1)%e.length];return[t,n,0,i,a,0]})))}columnLines(){let{scene:e,what:t}=this,n=C(e,t.choice,`settlement`),r=.07*this.extent();return Float32Array.from(e.head.plan.columns.flatMap(({ring:e},t)=>{let i=-n[this.feet[t]]*this.enlarged/1e3,a=e.length>8?e.filter((t,n)=>n%Math.ceil(e.length/8)===0):e;return a.flatMap(([e,t],n)=>{let[o,s]=a[(n+1)%a.length];return[e,t,i,e,t,i+r,e,t,i+r,o,s,i+r]})}))}key(e){if(e.target!==this.element||e.ctrlKey||e.metaKey||e.altKey)return!1;let{controls:t}=this,n=Math.PI/24;switch(e.key){case`ArrowLeft`:t.rotateLeft(n);break;case`ArrowRight`:t.rotateLeft(-n);break;case`ArrowUp`:t.rotateUp(n);break;case`ArrowDown`:t.rotateUp(-n);break;case`+`:case`=`:t.dollyIn(.85);break;case`-`:t.dollyOut(.85);break;case`0`:return this.fit(),!0;default:return!1}return this.fitted=!1,t.update(),this.request(),!0}request(){this.frame||=requestAnimationFrame(()=>{this.frame=0,this.draw()})}draw(e=this.stage.clientWidth,t=this.stage.clientHeight,n=Math.min(window.devicePixelRatio||1,2)){let{camera:r}=this;if(!e||!t)return;r.aspect!==e/t&&(r.aspect=e/t,r.updateProjectionMatrix()),r.updateMatrixWorld();let i=r.position.distanceTo(this.controls.target),a=t*n/(2*Math.tan(ff*Math.PI/360)*i);this.painter.draw(r,this.enlarged/1e3,e,t,n,(this.tiling?.side??1)*a<fu)}};function mf({mesh:e},t,n){let[r,i]=[0,1/0];for(let a=0;a<e.nodeCount;a++){let o=(e.nodes[2*a]-t)**2+(e.nodes[2*a+1]-n)**2;o<i&&([r,i]=[a,o])}return r}var hf=!0,gf=`uplot`,_f=`u-hz`,vf=`u-vt`,yf=`u-title`,bf=`u-wrap`,xf=`u-under`,Sf=`u-over`,Cf=`u-axis`,wf=`u-off`,Tf=`u-select`,Ef=`u-cursor-x`,Df=`u-cursor-y`,Of=`u-cursor-pt`,kf=`u-legend`,Af=`u-live`,jf=`u-inline`,Mf=`u-series`,Nf=`u-marker`,Pf=`u-label`,Ff=`u-value`,If=`width`,Lf=`height`,Rf=`top`,zf=`bottom`,Bf=`left`,Vf=`right`,Hf=`#000`,Uf=`#0000`,Wf=`mousemove`,Gf=`mousedown`,Kf=`mouseup`,qf=`mouseenter`,Jf=`mouseleave`,Yf=`dblclick`,Xf=`resize`,Zf=`scroll`,Qf=`change`,$f=`dppxchange`,ep=`--`,tp=typeof window<`u`,np=tp?document:null,rp=tp?window:null,ip=tp?navigator:null,ap,op;function sp(){let e=devicePixelRatio;ap!=e&&(ap=e,op&&Sp(Qf,op,sp),op=matchMedia(`(min-resolution: ${ap-.001}dppx) and (max-resolution: ${ap+.001}dppx)`),xp(Qf,op,sp),rp.dispatchEvent(new CustomEvent($f)))}function cp(e,t){if(t!=null){let n=e.classList;!n.contains(t)&&n.add(t)}}function lp(e,t){let n=e.classList;n.contains(t)&&n.remove(t)}function up(e,t,n){e.style[t]=n+`px`}function dp(e,t,n,r){let i=np.createElement(e);return t!=null&&cp(i,t),n?.insertBefore(i,r),i}function fp(e,t){return dp(`div`,e,t)}var pp=new WeakMap;function mp(e,t,n,r,i){let a=`translate(`+t+`px,`+n+`px)`;a!=pp.get(e)&&(e.style.transform=a,pp.set(e,a),t<0||n<0||t>r||n>i?cp(e,wf):lp(e,wf))}var hp=new WeakMap;function gp(e,t,n){let r=t+n;r!=hp.get(e)&&(hp.set(e,r),e.style.background=t,e.style.borderColor=n)}var _p=new WeakMap;function vp(e,t,n,r){let i=t+``+n;i!=_p.get(e)&&(_p.set(e,i),e.style.height=n+`px`,e.style.width=t+`px`,e.style.marginLeft=r?-t/2+`px`:0,e.style.marginTop=r?-n/2+`px`:0)}var yp={passive:!0},bp={...yp,capture:!0};function xp(e,t,n,r){t.addEventListener(e,n,r?bp:yp)}function Sp(e,t,n,r){t.removeEventListener(e,n,yp)}tp&&sp();function Cp(e,t,n,r){let i;n||=0,r||=t.length-1;let a=r<=2147483647;for(;r-n>1;)i=a?n+r>>1:Gp((n+r)/2),t[i]<e?n=i:r=i;return e-t[n]<=t[r]-e?n:r}function wp(e){return(t,n,r)=>{let i=-1,a=-1;for(let a=n;a<=r;a++)if(e(t[a])){i=a;break}for(let i=r;i>=n;i--)if(e(t[i])){a=i;break}return[i,a]}}var Tp=e=>e!=null,Ep=e=>e!=null&&e>0,Dp=wp(Tp),Op=wp(Ep);function kp(e,t,n,r=0,i=!1){let a=i?Op:Dp,o=i?Ep:Tp;[t,n]=a(e,t,n);let s=e[t],c=e[t];if(t>-1){if(r==1)s=e[t],c=e[n];else if(r==-1)s=e[n],c=e[t];else for(let r=t;r<=n;r++){let t=e[r];o(t)&&(t<s?s=t:t>c&&(c=t))}}return[s??nm,c??-nm]}function Ap(e,t,n,r){let i=Zp(e),a=Zp(t);e==t&&(i==-1?(e*=n,t/=n):(e/=n,t*=n));let o=n==10?Qp:$p,s=i==1?Gp:qp,c=a==1?qp:Gp,l=s(o(Wp(e))),u=c(o(Wp(t))),d=Xp(n,l),f=Xp(n,u);return n==10&&(l<0&&(d=vm(d,-l)),u<0&&(f=vm(f,-u))),r||n==2?(e=d*i,t=f*a):(e=_m(e,d),t=gm(t,f)),[e,t]}function jp(e,t,n,r){let i=Ap(e,t,n,r);return e==0&&(i[0]=0),t==0&&(i[1]=0),i}var Mp=.1,Np={mode:3,pad:Mp},Pp={pad:0,soft:null,mode:0},Fp={min:Pp,max:Pp};function Ip(e,t,n,r){return km(n)?zp(e,t,n):(Pp.pad=n,Pp.soft=r?0:null,Pp.mode=r?3:0,zp(e,t,Fp))}function Lp(e,t){return e??t}function Rp(e,t,n){for(t=Lp(t,0),n=Lp(n,e.length-1);t<=n;){if(e[t]!=null)return!0;t++}return!1}function zp(e,t,n){let r=n.min,i=n.max,a=Lp(r.pad,0),o=Lp(i.pad,0),s=Lp(r.hard,-nm),c=Lp(i.hard,nm),l=Lp(r.soft,nm),u=Lp(i.soft,-nm),d=Lp(r.mode,0),f=Lp(i.mode,0),p=t-e,m=Qp(p),h=Yp(Wp(e),Wp(t)),g=Wp(Qp(h)-m);(p<1e-24||g>10)&&(p=0,(e==0||t==0)&&(p=1e-24,d==2&&l!=nm&&(a=0),f==2&&u!=-nm&&(o=0)));let _=p||h||1e3,v=Xp(10,Gp(Qp(_))),y=vm(_m(e-_*(p==0?e==0?.1:1:a),v/10),24),b=e>=l&&(d==1||d==3&&y<=l||d==2&&y>=l)?l:nm,x=Yp(s,y<b&&e>=b?b:Jp(b,y)),S=vm(gm(t+_*(p==0?t==0?.1:1:o),v/10),24),C=t<=u&&(f==1||f==3&&S>=u||f==2&&S<=u)?u:-nm,w=Jp(c,S>C&&t<=C?C:Yp(C,S));return x==w&&x==0&&(w=100),[x,w]}var Bp=new Intl.NumberFormat(tp?ip.language:`en-US`),Vp=e=>Bp.format(e),Hp=Math,Up=Hp.PI,Wp=Hp.abs,Gp=Hp.floor,Kp=Hp.round,qp=Hp.ceil,Jp=Hp.min,Yp=Hp.max,Xp=Hp.pow,Zp=Hp.sign,Qp=Hp.log10,$p=Hp.log2,em=(e,t=1)=>Hp.sinh(e)*t,tm=(e,t=1)=>Hp.asinh(e/t),nm=1/0;function rm(e){return(Qp((e^e>>31)-(e>>31))|0)+1}function im(e,t,n){return Jp(Yp(e,t),n)}function am(e){return typeof e==`function`}function om(e){return am(e)?e:()=>e}var sm=()=>{},cm=e=>e,lm=(e,t)=>t,um=e=>null,dm=e=>!0,fm=(e,t)=>e==t,pm=/\.\d*?(?=9{6,}|0{6,})/gm,mm=e=>{if(Em(e)||ym.has(e))return e;let t=`${e}`,n=t.match(pm);if(n==null)return e;let r=n[0].length-1;if(t.indexOf(`e-`)!=-1){let[e,n]=t.split(`e`);return+`${mm(e)}e${n}`}return vm(e,r)};function hm(e,t){return mm(vm(mm(e/t))*t)}function gm(e,t){return mm(qp(mm(e/t))*t)}function _m(e,t){return mm(Gp(mm(e/t))*t)}function vm(e,t=0){if(Em(e))return e;let n=10**t;return Kp(e*n*(1+2**-52))/n}var ym=new Map;function bm(e){return((``+e).split(`.`)[1]||``).length}function xm(e,t,n,r){let i=[],a=r.map(bm);for(let o=t;o<n;o++){let t=Wp(o),n=vm(Xp(e,o),t);for(let s=0;s<r.length;s++){let c=e==10?+`${r[s]}e${o}`:r[s]*n,l=(o>=0?0:t)+(o>=a[s]?0:a[s]),u=e==10?c:vm(c,l);i.push(u),ym.set(u,l)}}return i}var Sm={},Cm=[],wm=[null,null],Tm=Array.isArray,Em=Number.isInteger,Dm=e=>e===void 0;function Om(e){return typeof e==`string`}function km(e){let t=!1;if(e!=null){let n=e.constructor;t=n==null||n==Object}return t}function Am(e){return typeof e==`object`&&!!e}var jm=Object.getPrototypeOf(Uint8Array),Mm=`__proto__`;function Nm(e,t=km){let n;if(Tm(e)){let r=e.find(e=>e!=null);if(Tm(r)||t(r)){n=Array(e.length);for(let r=0;r<e.length;r++)n[r]=Nm(e[r],t)}else n=e.slice()}else if(e instanceof jm)n=e.slice();else if(t(e)){n={};for(let r in e)r!=Mm&&(n[r]=Nm(e[r],t))}else n=e;return n}function Pm(e){let t=arguments;for(let n=1;n<t.length;n++){let r=t[n];for(let t in r)t!=Mm&&(km(e[t])?Pm(e[t],Nm(r[t])):e[t]=Nm(r[t]))}return e}var Fm=0,Im=1,Lm=2;function Rm(e,t,n){for(let r=0,i,a=-1;r<t.length;r++){let o=t[r];if(o>a){for(i=o-1;i>=0&&e[i]==null;)e[i--]=null;for(i=o+1;i<n&&e[i]==null;)e[a=i++]=null}}}function zm(e,t){if(Hm(e)){let t=e[0].slice();for(let n=1;n<e.length;n++)t.push(...e[n].slice(1));return Um(t[0])||(t=Vm(t)),t}let n=new Set;for(let t=0;t<e.length;t++){let r=e[t][0],i=r.length;for(let e=0;e<i;e++)n.add(r[e])}let r=[Array.from(n).sort((e,t)=>e-t)],i=r[0].length,a=new Map;for(let e=0;e<i;e++)a.set(r[0][e],e);for(let n=0;n<e.length;n++){let o=e[n],s=o[0];for(let e=1;e<o.length;e++){let c=o[e],l=Array(i).fill(void 0),u=t?t[n][e]:Im,d=[];for(let e=0;e<c.length;e++){let t=c[e],n=a.get(s[e]);t===null?u!=Fm&&(l[n]=t,u==Lm&&d.push(n)):l[n]=t}Rm(l,d,i),r.push(l)}}return r}var Bm=typeof queueMicrotask>`u`?e=>Promise.resolve().then(e):queueMicrotask;function Vm(e){let t=e[0],n=t.length,r=Array(n);for(let e=0;e<r.length;e++)r[e]=e;r.sort((e,n)=>t[e]-t[n]);let i=[];for(let t=0;t<e.length;t++){let a=e[t],o=Array(n);for(let e=0;e<n;e++)o[e]=a[r[e]];i.push(o)}return i}function Hm(e){let t=e[0][0],n=t.length;for(let r=1;r<e.length;r++){let i=e[r][0];if(i.length!=n)return!1;if(i!=t){for(let e=0;e<n;e++)if(i[e]!=t[e])return!1}}return!0}function Um(e,t=100){let n=e.length;if(n<=1)return!0;let r=0,i=n-1;for(;r<=i&&e[r]==null;)r++;for(;i>=r&&e[i]==null;)i--;if(i<=r)return!0;let a=Yp(1,Gp((i-r+1)/t));for(let t=e[r],n=r+a;n<=i;n+=a){let r=e[n];if(r!=null){if(r<=t)return!1;t=r}}return!0}var Wm=[`January`,`February`,`March`,`April`,`May`,`June`,`July`,`August`,`September`,`October`,`November`,`December`],Gm=[`Sunday`,`Monday`,`Tuesday`,`Wednesday`,`Thursday`,`Friday`,`Saturday`];function Km(e){return e.slice(0,3)}var qm=Gm.map(Km),Jm={MMMM:Wm,MMM:Wm.map(Km),WWWW:Gm,WWW:qm};function Ym(e){return(e<10?`0`:``)+e}function Xm(e){return(e<10?`00`:e<100?`0`:``)+e}var Zm={YYYY:e=>e.getFullYear(),YY:e=>(e.getFullYear()+``).slice(2),MMMM:(e,t)=>t.MMMM[e.getMonth()],MMM:(e,t)=>t.MMM[e.getMonth()],MM:e=>Ym(e.getMonth()+1),M:e=>e.getMonth()+1,DD:e=>Ym(e.getDate()),D:e=>e.getDate(),WWWW:(e,t)=>t.WWWW[e.getDay()],WWW:(e,t)=>t.WWW[e.getDay()],HH:e=>Ym(e.getHours()),H:e=>e.getHours(),h:e=>{let t=e.getHours();return t==0?12:t>12?t-12:t},AA:e=>e.getHours()>=12?`PM`:`AM`,aa:e=>e.getHours()>=12?`pm`:`am`,a:e=>e.getHours()>=12?`p`:`a`,mm:e=>Ym(e.getMinutes()),m:e=>e.getMinutes(),ss:e=>Ym(e.getSeconds()),s:e=>e.getSeconds(),fff:e=>Xm(e.getMilliseconds())};function Qm(e,t){t||=Jm;let n=[],r=/\{([a-z]+)\}|[^{]+/gi,i;for(;i=r.exec(e);)n.push(i[0][0]==`{`?Zm[i[1]]:i[0]);return e=>{let r=``;for(let i=0;i<n.length;i++)r+=typeof n[i]==`string`?n[i]:n[i](e,t);return r}}var $m=new Intl.DateTimeFormat().resolvedOptions().timeZone;function eh(e,t){let n;return t==`UTC`||t==`Etc/UTC`?n=new Date(+e+e.getTimezoneOffset()*6e4):t==$m?n=e:(n=new Date(e.toLocaleString(`en-US`,{timeZone:t})),n.setMilliseconds(e.getMilliseconds())),n}var th=e=>e%1==0,nh=[1,2,2.5,5],rh=xm(10,-32,0,nh),ih=xm(10,0,32,nh),ah=ih.filter(th),oh=rh.concat(ih),sh=`
`,ch=`{YYYY}`,lh=sh+ch,uh=`{M}/{D}`,dh=sh+uh,fh=dh+`/{YY}`,ph=`{aa}`,mh=`{h}:{mm}`+ph,hh=sh+mh,gh=`:{ss}`,_h=null;function vh(e){let t=e*1e3,n=t*60,r=n*60,i=r*24,a=i*30,o=i*365,s=(e==1?xm(10,0,3,nh).filter(th):xm(10,-3,0,nh)).concat([t,t*5,t*10,t*15,t*30,n,n*5,n*10,n*15,n*30,r,r*2,r*3,r*4,r*6,r*8,r*12,i,i*2,i*3,i*4,i*5,i*6,i*7,i*8,i*9,i*10,i*15,a,a*2,a*3,a*4,a*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,ch,_h,_h,_h,_h,_h,_h,1],[i*28,`{MMM}`,lh,_h,_h,_h,_h,_h,1],[i,uh,lh,_h,_h,_h,_h,_h,1],[r,`{h}`+ph,fh,_h,dh,_h,_h,_h,1],[n,mh,fh,_h,dh,_h,_h,_h,1],[t,gh,fh+` `+mh,_h,dh+` `+mh,_h,hh,_h,1],[e,gh+`.{fff}`,fh+` `+mh,_h,dh+` `+mh,_h,hh,_h,1]];function l(t){return(s,c,l,u,d,f)=>{let p=[],m=d>=o,h=d>=a&&d<o,g=t(l),_=vm(g*e,3),v=Oh(g.getFullYear(),m?0:g.getMonth(),h||m?1:g.getDate()),y=vm(v*e,3);if(h||m){let n=h?d/a:0,r=m?d/o:0,i=_==y?_:vm(Oh(v.getFullYear()+r,v.getMonth()+n,1)*e,3),s=new Date(Kp(i/e)),c=s.getFullYear(),l=s.getMonth();for(let a=0;i<=u;a++){let o=Oh(c+r*a,l+n*a,1),s=o-t(vm(o*e,3));i=vm((+o+s)*e,3),i<=u&&p.push(i)}}else{let a=d>=i?i:d,o=y+(Gp(l)-Gp(_))+gm(_-y,a);p.push(o);let m=t(o),h=m.getHours()+m.getMinutes()/n+m.getSeconds()/r,g=d/r,v=f/s.axes[c]._space;for(;o=vm(o+d,e==1?0:3),!(o>u);)if(g>1){let e=Gp(vm(h+g,6))%24,n=t(o).getHours()-e;n>1&&(n=-1),o-=n*r,h=(h+g)%24;let i=p[p.length-1];vm((o-i)/d,3)*v>=.7&&p.push(o)}else p.push(o)}return p}}return[s,c,l]}var[yh,bh,xh]=vh(1),[Sh,Ch,wh]=vh(.001);xm(2,-53,53,[1]);function Th(e,t){return e.map(e=>e.map((n,r)=>r==0||r==8||n==null?n:t(r==1||e[8]==0?n:e[1]+n)))}function Eh(e,t){return(n,r,i,a,o)=>{let s=t.find(e=>o>=e[0])||t[t.length-1],c,l,u,d,f,p;return r.map(t=>{let n=e(t),r=n.getFullYear(),i=n.getMonth(),a=n.getDate(),o=n.getHours(),m=n.getMinutes(),h=n.getSeconds(),g=r!=c&&s[2]||i!=l&&s[3]||a!=u&&s[4]||o!=d&&s[5]||m!=f&&s[6]||h!=p&&s[7]||s[1];return c=r,l=i,u=a,d=o,f=m,p=h,g(n)})}}function Dh(e,t){let n=Qm(t);return(t,r,i,a,o)=>r.map(t=>n(e(t)))}function Oh(e,t,n){return new Date(e,t,n)}function kh(e,t){return t(e)}var Ah=`{YYYY}-{MM}-{DD} {h}:{mm}{aa}`;function jh(e,t){return(n,r,i,a)=>a==null?ep:t(e(r))}function Mh(e,t){let n=e.series[t];return n.width?n.stroke(e,t):n.points.width?n.points.stroke(e,t):null}function Nh(e,t){return e.series[t].fill(e,t)}var Ph={show:!0,live:!0,isolate:!1,mount:sm,markers:{show:!0,width:2,stroke:Mh,fill:Nh,dash:`solid`},idx:null,idxs:null,values:[]};function Fh(e,t){let n=e.cursor.points,r=fp(),i=n.size(e,t);up(r,If,i),up(r,Lf,i);let a=i/-2;up(r,`marginLeft`,a),up(r,`marginTop`,a);let o=n.width(e,t,i);return o&&up(r,`borderWidth`,o),r}function Ih(e,t){let n=e.series[t].points;return n._fill||n._stroke}function Lh(e,t){let n=e.series[t].points;return n._stroke||n._fill}function Rh(e,t){return e.series[t].points.size}var zh=[0,0];function Bh(e,t,n){return zh[0]=t,zh[1]=n,zh}function Vh(e,t,n,r=!0){return e=>{e.button!=0||r&&e.target!=t||n(e)}}function Hh(e,t,n,r=!0){return e=>{r&&e.target!=t||n(e)}}var Uh={show:!0,x:!0,y:!0,lock:!1,move:Bh,points:{one:!1,show:Fh,size:Rh,width:0,stroke:Lh,fill:Ih},bind:{mousedown:Vh,mouseup:Vh,click:Vh,dblclick:Vh,mousemove:Hh,mouseleave:Hh,mouseenter:Hh},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(e,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(e,t,n,r,i)=>r-i,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Wh={show:!0,stroke:`rgba(0,0,0,0.07)`,width:2},Gh=Pm({},Wh,{filter:lm}),Kh=Pm({},Gh,{size:10}),qh=Pm({},Wh,{show:!1}),Jh=`12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"`,Yh=`bold `+Jh,Xh=1.5,Zh={show:!0,scale:`x`,stroke:Hf,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Yh,side:2,grid:Gh,ticks:Kh,border:qh,font:Jh,lineGap:Xh,rotate:0},Qh=`Value`,$h=`Time`,eg={show:!0,scale:`x`,auto:!1,sorted:1,min:nm,max:-1/0,idxs:[]};function tg(e,t,n,r,i){return t.map(e=>e==null?``:Vp(e))}function ng(e,t,n,r,i,a,o){let s=[],c=ym.get(i)||0;n=o?n:vm(gm(n,i),c);for(let e=n;e<=r;e=vm(e+i,c))s.push(Object.is(e,-0)?0:e);return s}function rg(e,t,n,r,i,a,o){let s=[],c=e.scales[e.axes[t].scale].log;i=Xp(c,Gp((c==10?Qp:$p)(n))),c==10&&(i=oh[Cp(i,oh)]);let l=n,u=i*c;c==10&&(u=oh[Cp(u,oh)]);do s.push(l),l+=i,c==10&&!ym.has(l)&&(l=vm(l,ym.get(i))),l>=u&&(i=l,u=i*c,c==10&&(u=oh[Cp(u,oh)]));while(l<=r);return s}function ig(e,t,n,r,i,a,o){let s=e.scales[e.axes[t].scale].asinh,c=r>s?rg(e,t,Yp(s,n),r,i):[s],l=r>=0&&n<=0?[0]:[];return(n<-s?rg(e,t,Yp(s,-r),-n,i):[s]).reverse().map(e=>-e).concat(l,c)}var ag=/./,og=/[12357]/,sg=/[125]/,cg=/1/,lg=(e,t,n,r)=>e.map((e,i)=>t==4&&e==0||i%r==0&&n.test(e.toExponential()[+(e<0)])?e:null);function ug(e,t,n,r,i){let a=e.axes[n],o=a.scale,s=e.scales[o],c=e.valToPos,l=a._space,u=c(10,o),d=c(9,o)-u>=l?ag:c(7,o)-u>=l?og:c(5,o)-u>=l?sg:cg;if(d==cg){let e=Wp(c(1,o)-u);if(e<l)return lg(t.slice().reverse(),s.distr,d,qp(l/e)).reverse()}return lg(t,s.distr,d,1)}function dg(e,t,n,r,i){let a=e.axes[n],o=a.scale,s=a._space,c=e.valToPos,l=Wp(c(1,o)-c(2,o));return l<s?lg(t.slice().reverse(),3,ag,qp(s/l)).reverse():t}function fg(e,t,n,r){return r==null?ep:t==null?``:Vp(t)}var pg={show:!0,scale:`y`,stroke:Hf,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Yh,side:3,grid:Gh,ticks:Kh,border:qh,font:Jh,lineGap:Xh,rotate:0};function mg(e,t){return vm((3+(e||1)*2)*t,3)}function hg(e,t){let{scale:n,idxs:r}=e.series[0],i=e._data[0],a=e.valToPos(i[r[0]],n,!0),o=Wp(e.valToPos(i[r[1]],n,!0)-a)/(e.series[t].points.space*ap);return r[1]-r[0]<=o}var gg={scale:null,auto:!0,sorted:0,min:nm,max:-1/0},_g=(e,t,n,r,i)=>i,vg={show:!0,auto:!0,sorted:0,gaps:_g,alpha:1,facets:[Pm({},gg,{scale:`x`}),Pm({},gg,{scale:`y`})]},yg={scale:`y`,auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:_g,alpha:1,points:{show:hg,filter:null},values:null,min:nm,max:-1/0,idxs:[],path:null,clip:null};function bg(e,t,n,r,i){return n/10}var xg={time:hf,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Sg=Pm({},xg,{time:!1,ori:1}),Cg={};function wg(e,t){let n=Cg[e];return n||(n={key:e,plots:[],sub(e){n.plots.push(e)},unsub(e){n.plots=n.plots.filter(t=>t!=e)},pub(e,t,r,i,a,o,s){for(let c=0;c<n.plots.length;c++)n.plots[c]!=t&&n.plots[c].pub(e,t,r,i,a,o,s)}},e!=null&&(Cg[e]=n)),n}var Tg=1,Eg=2;function Dg(e,t,n){let r=e.mode,i=e.series[t],a=r==2?e._data[t]:e._data,o=e.scales,s=e.bbox,c=a[0],l=r==2?a[1]:a[t],u=r==2?o[i.facets[0].scale]:o[e.series[0].scale],d=r==2?o[i.facets[1].scale]:o[i.scale],f=s.left,p=s.top,m=s.width,h=s.height,g=e.valToPosH,_=e.valToPosV;return u.ori==0?n(i,c,l,u,d,g,_,f,p,m,h,Ig,Rg,Bg,Hg,Wg):n(i,c,l,u,d,_,g,p,f,h,m,Lg,zg,Vg,Ug,Gg)}function Og(e,t){let n=0,r=0,i=Lp(e.bands,Cm);for(let e=0;e<i.length;e++){let a=i[e];a.series[0]==t?n=a.dir:a.series[1]==t&&(a.dir==1?r|=1:r|=2)}return[n,r==1?-1:r==2?1:r==3?2:0]}function kg(e,t,n,r,i){let a=e.mode,o=e.series[t],s=a==2?o.facets[1].scale:o.scale,c=e.scales[s];return i==-1?c.min:i==1?c.max:c.distr==3?c.dir==1?c.min:c.max:0}function Ag(e,t,n,r,i,a){return Dg(e,t,(e,t,o,s,c,l,u,d,f,p,m)=>{let h=e.pxRound,g=s.dir*(s.ori==0?1:-1),_=s.ori==0?Rg:zg,v,y;g==1?(v=n,y=r):(v=r,y=n);let b=h(l(t[v],s,p,d)),x=h(u(o[v],c,m,f)),S=h(l(t[y],s,p,d)),C=h(u(a==1?c.max:c.min,c,m,f)),w=new Path2D(i);return _(w,S,C),_(w,b,C),_(w,b,x),w})}function jg(e,t,n,r,i,a){let o=null;if(e.length>0){o=new Path2D;let s=t==0?Bg:Vg,c=n;for(let t=0;t<e.length;t++){let n=e[t];if(n[1]>n[0]){let e=n[0]-c;e>0&&s(o,c,r,e,r+a),c=n[1]}}let l=n+i-c;l>0&&s(o,c,r-5,l,r+a+10)}return o}function Mg(e,t,n){let r=e[e.length-1];r&&r[0]==t?r[1]=n:e.push([t,n])}function Ng(e,t,n,r,i,a,o){let s=[],c=e.length;for(let l=i==1?n:r;l>=n&&l<=r;l+=i)if(t[l]===null){let u=l,d=l;if(i==1)for(;++l<=r&&t[l]===null;)d=l;else for(;--l>=n&&t[l]===null;)d=l;let f=a(e[u]),p=d==u?f:a(e[d]),m=u-i;f=o<=0&&m>=0&&m<c?a(e[m]):f;let h=d+i;p=o>=0&&h>=0&&h<c?a(e[h]):p,p>=f&&s.push([f,p])}return s}function Pg(e){return e==0?cm:e==1?Kp:t=>hm(t,e)}function Fg(e){let t=e==0?Ig:Lg,n=e==0?(e,t,n,r,i,a)=>{e.arcTo(t,n,r,i,a)}:(e,t,n,r,i,a)=>{e.arcTo(n,t,i,r,a)},r=e==0?(e,t,n,r,i)=>{e.rect(t,n,r,i)}:(e,t,n,r,i)=>{e.rect(n,t,i,r)};return(e,i,a,o,s,c=0,l=0)=>{c==0&&l==0?r(e,i,a,o,s):(c=Jp(c,o/2,s/2),l=Jp(l,o/2,s/2),t(e,i+c,a),n(e,i+o,a,i+o,a+s,c),n(e,i+o,a+s,i,a+s,l),n(e,i,a+s,i,a,l),n(e,i,a,i+o,a,c),e.closePath())}}var Ig=(e,t,n)=>{e.moveTo(t,n)},Lg=(e,t,n)=>{e.moveTo(n,t)},Rg=(e,t,n)=>{e.lineTo(t,n)},zg=(e,t,n)=>{e.lineTo(n,t)},Bg=Fg(0),Vg=Fg(1),Hg=(e,t,n,r,i,a)=>{e.arc(t,n,r,i,a)},Ug=(e,t,n,r,i,a)=>{e.arc(n,t,r,i,a)},Wg=(e,t,n,r,i,a,o)=>{e.bezierCurveTo(t,n,r,i,a,o)},Gg=(e,t,n,r,i,a,o)=>{e.bezierCurveTo(n,t,i,r,o,a)};function Kg(e){return(e,t,n,r,i)=>Dg(e,t,(t,a,o,s,c,l,u,d,f,p,m)=>{let{pxRound:h,points:g}=t,_,v;s.ori==0?(_=Ig,v=Hg):(_=Lg,v=Ug);let y=vm(g.width*ap,3),b=(g.size-g.width)/2*ap,x=vm(b*2,3),S=new Path2D,C=new Path2D,{left:w,top:T,width:E,height:D}=e.bbox;Bg(C,w-x,T-x,E+x*2,D+x*2);let O=e=>{if(o[e]!=null){let t=h(l(a[e],s,p,d)),n=h(u(o[e],c,m,f));_(S,t+b,n),v(S,t,n,b,0,Up*2)}};if(i)i.forEach(O);else for(let e=n;e<=r;e++)O(e);return{stroke:y>0?S:null,fill:S,clip:C,flags:3}})}function qg(e){return(t,n,r,i,a,o)=>{r!=i&&(a!=r&&o!=r&&e(t,n,r),a!=i&&o!=i&&e(t,n,i),e(t,n,o))}}var Jg=qg(Rg),Yg=qg(zg);function Xg(e){let t=Lp(e?.alignGaps,0);return(e,n,r,i)=>Dg(e,n,(a,o,s,c,l,u,d,f,p,m,h)=>{[r,i]=Dp(s,r,i);let g=a.pxRound,_=e=>g(u(e,c,m,f)),v=e=>g(d(e,l,h,p)),y,b;c.ori==0?(y=Rg,b=Jg):(y=zg,b=Yg);let x=c.dir*(c.ori==0?1:-1),S={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Tg},C=S.stroke,w=!1;if(i-r>=m*4){let t=t=>e.posToVal(t,c.key,!0),n=null,a=null,l,u,d,f=_(o[x==1?r:i]),p=_(o[r]),m=_(o[i]),h=t(x==1?p+1:m-1);for(let e=x==1?r:i;e>=r&&e<=i;e+=x){let r=o[e],i=(x==1?r<h:r>h)?f:_(r),c=s[e];i==f?c==null?c===null&&(w=!0):(u=c,n==null?(y(C,i,v(u)),l=n=a=u):u<n?n=u:u>a&&(a=u)):(n!=null&&b(C,f,v(n),v(a),v(l),v(u)),c==null?(n=a=null,c===null&&(w=!0)):(u=c,y(C,i,v(u)),n=a=l=u),f=i,h=t(f+x))}n!=null&&n!=a&&d!=f&&b(C,f,v(n),v(a),v(l),v(u))}else for(let e=x==1?r:i;e>=r&&e<=i;e+=x){let t=s[e];t===null?w=!0:t!=null&&y(C,_(o[e]),v(t))}let[T,E]=Og(e,n);if(a.fill!=null||T!=0){let t=S.fill=new Path2D(C),s=v(a.fillTo(e,n,a.min,a.max,T)),c=_(o[r]),l=_(o[i]);x==-1&&([l,c]=[c,l]),y(t,l,s),y(t,c,s)}if(!a.spanGaps){let l=[];w&&l.push(...Ng(o,s,r,i,x,_,t)),S.gaps=l=a.gaps(e,n,r,i,l),S.clip=jg(l,c.ori,f,p,m,h)}return E!=0&&(S.band=E==2?[Ag(e,n,r,i,C,-1),Ag(e,n,r,i,C,1)]:Ag(e,n,r,i,C,E)),S})}function Zg(e){let t=Lp(e.align,1),n=Lp(e.ascDesc,!1),r=Lp(e.alignGaps,0),i=Lp(e.extend,!1);return(e,a,o,s)=>Dg(e,a,(c,l,u,d,f,p,m,h,g,_,v)=>{[o,s]=Dp(u,o,s);let y=c.pxRound,{left:b,width:x}=e.bbox,S=e=>y(p(e,d,_,h)),C=e=>y(m(e,f,v,g)),w=d.ori==0?Rg:zg,T={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Tg},E=T.stroke,D=d.dir*(d.ori==0?1:-1),O=C(u[D==1?o:s]),k=S(l[D==1?o:s]),A=k,j=k;i&&t==-1&&(j=b,w(E,j,O)),w(E,k,O);for(let e=D==1?o:s;e>=o&&e<=s;e+=D){let n=u[e];if(n==null)continue;let r=S(l[e]),i=C(n);t==1?w(E,r,O):w(E,A,i),w(E,r,i),O=i,A=r}let M=A;i&&t==1&&(M=b+x,w(E,M,O));let[N,ee]=Og(e,a);if(c.fill!=null||N!=0){let t=T.fill=new Path2D(E),n=C(c.fillTo(e,a,c.min,c.max,N));w(t,M,n),w(t,j,n)}if(!c.spanGaps){let i=[];i.push(...Ng(l,u,o,s,D,S,r));let f=c.width*ap/2,p=n||t==1?f:-f,m=n||t==-1?-f:f;i.forEach(e=>{e[0]+=p,e[1]+=m}),T.gaps=i=c.gaps(e,a,o,s,i),T.clip=jg(i,d.ori,h,g,_,v)}return ee!=0&&(T.band=ee==2?[Ag(e,a,o,s,E,-1),Ag(e,a,o,s,E,1)]:Ag(e,a,o,s,E,ee)),T})}function Qg(e,t,n,r,i,a,o=nm){if(e.length>1){let s=null;for(let c=0,l=1/0;c<e.length;c++)if(t[c]!==void 0){if(s!=null){let t=Wp(e[c]-e[s]);t<l&&(l=t,o=Wp(n(e[c],r,i,a)-n(e[s],r,i,a)))}s=c}}return o}function $g(e){e||=Sm;let t=Lp(e.size,[.6,nm,1]),n=e.align||0,r=e.gap||0,i=e.radius;i=i==null?[0,0]:typeof i==`number`?[i,0]:i;let a=om(i),o=1-t[0],s=Lp(t[1],nm),c=Lp(t[2],1),l=Lp(e.disp,Sm),u=Lp(e.each,e=>{}),{fill:d,stroke:f}=l;return(e,t,i,p)=>Dg(e,t,(m,h,g,_,v,y,b,x,S,C,w)=>{let T=m.pxRound,E=n,D=r*ap,O=s*ap,k=c*ap,A,j;_.ori==0?[A,j]=a(e,t):[j,A]=a(e,t);let M=_.dir*(_.ori==0?1:-1),N=_.ori==0?Bg:Vg,ee=_.ori==0?u:(e,t,n,r,i,a,o)=>{u(e,t,n,i,r,o,a)},te=Lp(e.bands,Cm).find(e=>e.series[0]==t),ne=te==null?0:te.dir,re=m.fillTo(e,t,m.min,m.max,ne),ie=T(b(re,v,w,S)),P,ae,F,I=C,L=T(m.width*ap),oe=!1,se=null,ce=null,le=null,ue=null;d!=null&&(L==0||f!=null)&&(oe=!0,se=d.values(e,t,i,p),ce=new Map,new Set(se).forEach(e=>{e!=null&&ce.set(e,new Path2D)}),L>0&&(le=f.values(e,t,i,p),ue=new Map,new Set(le).forEach(e=>{e!=null&&ue.set(e,new Path2D)})));let{x0:de,size:fe}=l;if(de!=null&&fe!=null){E=1,h=de.values(e,t,i,p),de.unit==2&&(h=h.map(t=>e.posToVal(x+t*C,_.key,!0)));let n=fe.values(e,t,i,p);ae=fe.unit==2?n[0]*C:y(n[0],_,C,x)-y(0,_,C,x),I=Qg(h,g,y,_,C,x,I),F=I-ae+D}else I=Qg(h,g,y,_,C,x,I),F=I*o+D,ae=I-F;F<1&&(F=0),L>=ae/2&&(L=0),F<5&&(T=cm);let pe=F>0,me=I-F-(pe?L:0);ae=T(im(me,k,O)),P=(E==0?ae/2:E==M?0:ae)-E*M*((E==0?D/2:0)+(pe?L/2:0));let he={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},ge=oe?null:new Path2D,_e=null;if(te!=null)_e=e.data[te.series[1]];else{let{y0:n,y1:r}=l;n!=null&&r!=null&&(g=r.values(e,t,i,p),_e=n.values(e,t,i,p))}let ve=A*ae,ye=j*ae;for(let n=M==1?i:p;n>=i&&n<=p;n+=M){let r=g[n];if(r==null)continue;if(_e!=null){let e=_e[n]??0;if(r-e==0)continue;ie=b(e,v,w,S)}let i=y(_.distr!=2||l!=null?h[n]:n,_,C,x),a=b(Lp(r,re),v,w,S),o=T(i-P),s=T(Yp(a,ie)),c=T(Jp(a,ie)),u=s-c;if(r!=null){let i=r<0?ye:ve,a=r<0?ve:ye;oe?(L>0&&le[n]!=null&&N(ue.get(le[n]),o,c+Gp(L/2),ae,Yp(0,u-L),i,a),se[n]!=null&&N(ce.get(se[n]),o,c+Gp(L/2),ae,Yp(0,u-L),i,a)):N(ge,o,c+Gp(L/2),ae,Yp(0,u-L),i,a),ee(e,t,n,o-L/2,c,ae+L,u)}}return L>0?he.stroke=oe?ue:ge:oe||(he._fill=m.width==0?m._fill:m._stroke??m._fill,he.width=0),he.fill=oe?ce:ge,he})}function e_(e,t){let n=Lp(t?.alignGaps,0);return(t,r,i,a)=>Dg(t,r,(o,s,c,l,u,d,f,p,m,h,g)=>{[i,a]=Dp(c,i,a);let _=o.pxRound,v=e=>_(d(e,l,h,p)),y=e=>_(f(e,u,g,m)),b,x,S;l.ori==0?(b=Ig,S=Rg,x=Wg):(b=Lg,S=zg,x=Gg);let C=l.dir*(l.ori==0?1:-1),w=v(s[C==1?i:a]),T=w,E=[],D=[];for(let e=C==1?i:a;e>=i&&e<=a;e+=C)if(c[e]!=null){let t=s[e],n=v(t);E.push(T=n),D.push(y(c[e]))}let O={stroke:e(E,D,b,S,x,_),fill:null,clip:null,band:null,gaps:null,flags:Tg},k=O.stroke,[A,j]=Og(t,r);if(o.fill!=null||A!=0){let e=O.fill=new Path2D(k),n=y(o.fillTo(t,r,o.min,o.max,A));S(e,T,n),S(e,w,n)}if(!o.spanGaps){let e=[];e.push(...Ng(s,c,i,a,C,v,n)),O.gaps=e=o.gaps(t,r,i,a,e),O.clip=jg(e,l.ori,p,m,h,g)}return j!=0&&(O.band=j==2?[Ag(t,r,i,a,k,-1),Ag(t,r,i,a,k,1)]:Ag(t,r,i,a,k,j)),O})}function t_(e){return e_(n_,e)}function n_(e,t,n,r,i,a){let o=e.length;if(o<2)return null;let s=new Path2D;if(n(s,e[0],t[0]),o==2)r(s,e[1],t[1]);else{let n=Array(o),r=Array(o-1),a=Array(o-1),c=Array(o-1);for(let n=0;n<o-1;n++)a[n]=t[n+1]-t[n],c[n]=e[n+1]-e[n],r[n]=a[n]/c[n];n[0]=r[0];for(let e=1;e<o-1;e++)r[e]===0||r[e-1]===0||r[e-1]>0!=r[e]>0?n[e]=0:(n[e]=3*(c[e-1]+c[e])/((2*c[e]+c[e-1])/r[e-1]+(c[e]+2*c[e-1])/r[e]),isFinite(n[e])||(n[e]=0));n[o-1]=r[o-2];for(let r=0;r<o-1;r++)i(s,e[r]+c[r]/3,t[r]+n[r]*c[r]/3,e[r+1]-c[r]/3,t[r+1]-n[r+1]*c[r]/3,e[r+1],t[r+1])}return s}var r_=new Set;function i_(){for(let e of r_)e.syncRect(!0)}tp&&(xp(Xf,rp,i_),xp(Zf,rp,i_,!0),xp($f,rp,()=>{b_.pxRatio=ap}));var a_=Xg(),o_=Kg();function s_(e,t,n,r){return(r?[e[0],e[1]].concat(e.slice(2)):[e[0]].concat(e.slice(1))).map((e,r)=>l_(e,r,t,n))}function c_(e,t){return e.map((e,n)=>n==0?{}:Pm({},t,e))}function l_(e,t,n,r){return Pm({},t==0?n:r,e)}function u_(e,t,n){return t==null?wm:[t,n]}var d_=u_;function f_(e,t,n){return t==null?wm:Ip(t,n,Mp,!0)}function p_(e,t,n,r){return t==null?wm:Ap(t,n,e.scales[r].log,!1)}var m_=p_;function h_(e,t,n,r){return t==null?wm:jp(t,n,e.scales[r].log,!1)}var g_=h_;function __(e,t,n,r,i){let a=Yp(rm(e),rm(t)),o=t-e,s=Cp(i/r*o,n);do{let e=n[s],t=r*e/o;if(t>=i&&a+(e<5?ym.get(e):0)<=17)return[e,t]}while(++s<n.length);return[0,0]}function v_(e){let t,n;return e=e.replace(/(\d+)px/,(e,r)=>(t=Kp((n=+r)*ap))+`px`),[e,t,n]}function y_(e){e.show&&[e.font,e.labelFont].forEach(e=>{let t=vm(e[2]*ap,1);e[0]=e[0].replace(/[0-9.]+px/,t+`px`),e[1]=t})}function b_(e,t,n){let r={mode:Lp(e.mode,1)},i=r.mode;function a(e,t,n,r){let i=t.valToPct(e);return r+n*(t.dir==-1?1-i:i)}function o(e,t,n,r){let i=t.valToPct(e);return r+n*(t.dir==-1?i:1-i)}function s(e,t,n,r){return t.ori==0?a(e,t,n,r):o(e,t,n,r)}r.valToPosH=a,r.valToPosV=o;let c=!1;r.status=0;let l=r.root=fp(gf);if(e.id!=null&&(l.id=e.id),cp(l,e.class),e.title){let t=fp(yf,l);t.textContent=e.title}let u=dp(`canvas`),d=r.ctx=u.getContext(`2d`),f=fp(bf,l);xp(`click`,f,e=>{e.target===m&&(tn!=Zt||nn!=Qt)&&an.click(r,e)},!0);let p=r.under=fp(xf,f);f.appendChild(u);let m=r.over=fp(Sf,f);e=Nm(e);let h=+Lp(e.pxAlign,1),g=Pg(h);(e.plugins||[]).forEach(t=>{t.opts&&(e=t.opts(r,e)||e)});let _=e.ms||.001,v=r.series=i==1?s_(e.series||[],eg,yg,!1):c_(e.series||[null],vg),y=r.axes=s_(e.axes||[],Zh,pg,!0),b=r.scales={},x=r.bands=e.bands||[];x.forEach(e=>{e.fill=om(e.fill||null),e.dir=Lp(e.dir,-1)});let S=i==2?v[1].facets[0].scale:v[0].scale,C={axes:Lt,series:Et},w=(e.drawOrder||[`axes`,`series`]).map(e=>C[e]);function T(e){let t=e.distr==3?t=>Qp(t>0?t:e.clamp(r,t,e.min,e.max,e.key)):e.distr==4?t=>tm(t,e.asinh):e.distr==100?t=>e.fwd(t):e=>e;return n=>{let r=t(n),{_min:i,_max:a}=e,o=a-i;return(r-i)/o}}function E(t){let n=b[t];if(n==null){let r=(e.scales||Sm)[t]||Sm;if(r.from!=null){E(r.from);let e=Pm({},b[r.from],r,{key:t});e.valToPct=T(e),b[t]=e}else{n=b[t]=Pm({},t==S?xg:Sg,r),n.key=t;let e=n.time,a=n.range,o=Tm(a);if((t!=S||i==2&&!e)&&(o&&(a[0]==null||a[1]==null)&&(a={min:a[0]==null?Np:{mode:1,hard:a[0],soft:a[0]},max:a[1]==null?Np:{mode:1,hard:a[1],soft:a[1]}},o=!1),!o&&km(a))){let e=a;a=(t,n,r)=>n==null?wm:Ip(n,r,e)}n.range=om(a||(e?d_:t==S?n.distr==3?m_:n.distr==4?g_:u_:n.distr==3?p_:n.distr==4?h_:f_)),n.auto=om(!o&&n.auto),n.clamp=om(n.clamp||bg),n._min=n._max=null,n.valToPct=T(n)}}}E(`x`),E(`y`),i==1&&v.forEach(e=>{E(e.scale)}),y.forEach(e=>{E(e.scale)});for(let t in e.scales)E(t);let D=b[S],O=D.distr,k,A;D.ori==0?(cp(l,_f),k=a,A=o):(cp(l,vf),k=o,A=a);let j={};for(let e in b){let t=b[e];(t.min!=null||t.max!=null)&&(j[e]={min:t.min,max:t.max},t.min=t.max=null)}let M=e.tzDate||(e=>new Date(Kp(e/_))),N=e.fmtDate||Qm,ee=_==1?xh(M):wh(M),te=Eh(M,Th(_==1?bh:Ch,N)),ne=jh(M,kh(Ah,N)),re=[],ie=r.legend=Pm({},Ph,e.legend),P=r.cursor=Pm({},Uh,{drag:{y:i==2}},e.cursor),ae=ie.show,F=P.show,I=ie.markers;ie.idxs=re,I.width=om(I.width),I.dash=om(I.dash),I.stroke=om(I.stroke),I.fill=om(I.fill);let L,oe,se,ce=[],le=[],ue,de=!1,fe={};if(ie.live){let e=v[1]?v[1].values:null;de=e!=null,ue=de?e(r,1,0):{_:0};for(let e in ue)fe[e]=ep}if(ae){if(L=dp(`table`,kf,l),se=dp(`tbody`,null,L),ie.mount(r,L),de){oe=dp(`thead`,null,L,se);let e=dp(`tr`,null,oe);for(var pe in dp(`th`,null,e),ue)dp(`th`,Pf,e).textContent=pe}else cp(L,jf),ie.live&&cp(L,Af)}let me={show:!0},he={show:!1};function ge(e,t){if(t==0&&(de||!ie.live||i==2))return wm;let n=[],a=dp(`tr`,Mf,se,se.childNodes[t]);cp(a,e.class),e.show||cp(a,wf);let o=dp(`th`,null,a);if(I.show){let e=fp(Nf,o);if(t>0){let n=I.width(r,t);n&&(e.style.border=n+`px `+I.dash(r,t)+` `+I.stroke(r,t)),e.style.background=I.fill(r,t)}}let s=fp(Pf,o);for(var c in e.label instanceof HTMLElement?s.appendChild(e.label):s.textContent=e.label,t>0&&(I.show||(s.style.color=e.width>0?I.stroke(r,t):I.fill(r,t)),ve(`click`,o,t=>{if(P._lock)return;ze(t);let n=v.indexOf(e);if((t.ctrlKey||t.metaKey)!=ie.isolate){let e=v.some((e,t)=>t>0&&t!=n&&e.show);v.forEach((t,r)=>{r>0&&pn(r,e?r==n?me:he:me,!0,Yn.setSeries)})}else pn(n,{show:!e.show},!0,Yn.setSeries)},!1),He&&ve(qf,o,t=>{P._lock||(ze(t),pn(v.indexOf(e),xn,!0,Yn.setSeries))},!1)),ue){let e=dp(`td`,Ff,a);e.textContent=`--`,n.push(e)}return[a,n]}let _e=new Map;function ve(e,t,n,i=!0){let a=_e.get(t)||{},o=P.bind[e](r,t,n,i);o&&(xp(e,t,a[e]=o),_e.set(t,a))}function ye(e,t,n){let r=_e.get(t)||{};for(let n in r)(e==null||n==e)&&(Sp(n,t,r[n]),delete r[n]);e??_e.delete(t)}let be=0,R=0,z=0,B=0,xe=0,V=0,Se=xe,Ce=V,H=z,we=B,Te=0,Ee=0,De=0,Oe=0;r.bbox={};let ke=!1,U=!1,W=!1,Ae=!1,je=!1,Me=!1;function Ne(e,t,n){(n||e!=r.width||t!=r.height)&&Pe(e,t),Rt(!1),W=!0,U=!0,Ut()}function Pe(e,t){r.width=be=z=e,r.height=R=B=t,xe=V=0,Le(),Re();let n=r.bbox;Te=n.left=hm(xe*ap,.5),Ee=n.top=hm(V*ap,.5),De=n.width=hm(z*ap,.5),Oe=n.height=hm(B*ap,.5)}function Fe(){let e=!1,t=0;for(;!e;){t++;let n=Ft(t),i=It(t);e=t==3||n&&i,e||(Pe(r.width,r.height),U=!0)}}function Ie({width:e,height:t}){Ne(e,t)}r.setSize=Ie;function Le(){let e=!1,t=!1,n=!1,r=!1;y.forEach((i,a)=>{if(i.show&&i._show){let{side:a,_size:o}=i,s=a%2,c=o+(i.label==null?0:i.labelSize);c>0&&(s?(z-=c,a==3?(xe+=c,r=!0):n=!0):(B-=c,a==0?(V+=c,e=!0):t=!0))}}),Ze[0]=e,Ze[1]=n,Ze[2]=t,Ze[3]=r,z-=tt[1]+tt[3],xe+=tt[3],B-=tt[2]+tt[0],V+=tt[0]}function Re(){let e=xe+z,t=V+B,n=xe,r=V;function i(i,a){switch(i){case 1:return e+=a,e-a;case 2:return t+=a,t-a;case 3:return n-=a,n+a;case 0:return r-=a,r+a}}y.forEach((e,t)=>{if(e.show&&e._show){let t=e.side;e._pos=i(t,e._size),e.label!=null&&(e._lpos=i(t,e.labelSize))}})}if(P.dataIdx==null){let e=P.hover,n=e.skip=new Set(e.skip??[]);n.add(void 0);let r=e.prox=om(e.prox),i=e.bias??=0;P.dataIdx=(e,a,o,s)=>{if(a==0)return o;let c=o,l=r(e,a,o,s)??nm,u=l>=0&&l<nm,d=D.ori==0?z:B,f=P.left,p=t[0],m=t[a];if(n.has(m[o])){c=null;let e=null,t=null,r;if(i==0||i==-1)for(r=o;e==null&&r-->0;)n.has(m[r])||(e=r);if(i==0||i==1)for(r=o;t==null&&r++<m.length;)n.has(m[r])||(t=r);if(e!=null||t!=null){if(u){let n=e==null?-1/0:k(p[e],D,d,0),r=t==null?1/0:k(p[t],D,d,0),i=f-n,a=r-f;i<=a?i<=l&&(c=e):a<=l&&(c=t)}else c=t==null?e:e==null?t:o-e<=t-o?e:t}}else u&&Wp(f-k(p[o],D,d,0))>l&&(c=null);return c}}let ze=e=>{P.event=e};P.idxs=re,P._lock=!1;let Be=P.points;Be.show=om(Be.show),Be.size=om(Be.size),Be.stroke=om(Be.stroke),Be.width=om(Be.width),Be.fill=om(Be.fill);let Ve=r.focus=Pm({},e.focus||{alpha:.3},P.focus),He=Ve.prox>=0,Ue=He&&Be.one,We=[],Ge=[],Ke=[];function qe(e,t){let n=Be.show(r,t);if(n instanceof HTMLElement)return cp(n,Of),cp(n,e.class),mp(n,-10,-10,z,B),m.insertBefore(n,We[t]),n}function Je(e,t){if(i==1||t>0){let t=i==1&&b[e.scale].time,n=e.value;e.value=t?Om(n)?jh(M,kh(n,N)):n||ne:n||fg,e.label=e.label||(t?$h:Qh)}if(Ue||t>0){e.width=e.width==null?1:e.width,e.paths=e.paths||a_||um,e.fillTo=om(e.fillTo||kg),e.pxAlign=+Lp(e.pxAlign,h),e.pxRound=Pg(e.pxAlign),e.stroke=om(e.stroke||null),e.fill=om(e.fill||null),e._stroke=e._fill=e._paths=e._focus=null;let t=mg(Yp(1,e.width),1),n=e.points=Pm({},{size:t,width:Yp(1,t*.2),stroke:e.stroke,space:t*2,paths:o_,_stroke:null,_fill:null},e.points);n.show=om(n.show),n.filter=om(n.filter),n.fill=om(n.fill),n.stroke=om(n.stroke),n.paths=om(n.paths),n.pxAlign=e.pxAlign}if(ae){let n=ge(e,t);ce.splice(t,0,n[0]),le.splice(t,0,n[1]),ie.values.push(null)}if(F){re.splice(t,0,null);let n=null;Ue?t==0&&(n=qe(e,t)):t>0&&(n=qe(e,t)),We.splice(t,0,n),Ge.splice(t,0,0),Ke.splice(t,0,0)}qn(`addSeries`,t)}function Ye(e,t){t??=v.length,e=i==1?l_(e,t,eg,yg):l_(e,t,{},vg),v.splice(t,0,e),Je(v[t],t)}r.addSeries=Ye;function Xe(e){if(v.splice(e,1),ae){ie.values.splice(e,1),le.splice(e,1);let t=ce.splice(e,1)[0];ye(null,t.firstChild),t.remove()}F&&(re.splice(e,1),We.splice(e,1)[0].remove(),Ge.splice(e,1),Ke.splice(e,1)),qn(`delSeries`,e)}r.delSeries=Xe;let Ze=[!1,!1,!1,!1];function Qe(e,t){if(e._show=e.show,e.show){let n=e.side%2,i=b[e.scale];i??=(e.scale=n?v[1].scale:S,b[e.scale]);let a=i.time;e.size=om(e.size),e.space=om(e.space),e.rotate=om(e.rotate),Tm(e.incrs)&&e.incrs.forEach(e=>{!ym.has(e)&&ym.set(e,bm(e))}),e.incrs=om(e.incrs||(i.distr==2?ah:a?_==1?yh:Sh:oh)),e.splits=om(e.splits||(a&&i.distr==1?ee:i.distr==3?rg:i.distr==4?ig:ng)),e.stroke=om(e.stroke),e.grid.stroke=om(e.grid.stroke),e.ticks.stroke=om(e.ticks.stroke),e.border.stroke=om(e.border.stroke);let o=e.values;e.values=Tm(o)&&!Tm(o[0])?om(o):a?Tm(o)?Eh(M,Th(o,N)):Om(o)?Dh(M,o):o||te:o||tg,e.filter=om(e.filter||(i.distr>=3&&i.log==10?ug:i.distr==3&&i.log==2?dg:lm)),e.font=v_(e.font),e.labelFont=v_(e.labelFont),e._size=e.size(r,null,t,0),e._space=e._rotate=e._incrs=e._found=e._splits=e._values=null,e._size>0&&(Ze[t]=!0,e._el=fp(Cf,f))}}function $e(e,t,n,r){let[i,a,o,s]=n,c=t%2,l=0;return c==0&&(s||a)&&(l=t==0&&!i||t==2&&!o?Kp(Zh.size/3):0),c==1&&(i||o)&&(l=t==1&&!a||t==3&&!s?Kp(pg.size/2):0),l}let et=r.padding=(e.padding||[$e,$e,$e,$e]).map(e=>om(Lp(e,$e))),tt=r._padding=et.map((e,t)=>e(r,t,Ze,0)),nt,rt=null,it=null,at=i==1?v[0].idxs:null,ot=null,st=!1;function ct(e,n){if(t=e??[],r.data=r._data=t,i==2){nt=0;for(let e=1;e<v.length;e++)nt+=t[e][0].length}else{t.length==0&&(r.data=r._data=t=[[]]),ot=t[0],nt=ot.length;let e=t;if(O==2){e=t.slice();let n=e[0]=Array(nt);for(let e=0;e<nt;e++)n[e]=e}r._data=t=e}if(Rt(!0),qn(`setData`),O==2&&(W=!0),n!==!1){let e=D;e.auto(r,st)?lt():fn(S,e.min,e.max),Ae||=P.left>=0,Me=!0,Ut()}}r.setData=ct;function lt(){st=!0;let e,n;i==1&&(nt>0?(rt=at[0]=0,it=at[1]=nt-1,e=t[0][rt],n=t[0][it],O==2?(e=rt,n=it):e==n&&(O==3?[e,n]=Ap(e,e,D.log,!1):O==4?[e,n]=jp(e,e,D.log,!1):D.time?n=e+Kp(86400/_):[e,n]=Ip(e,n,Mp,!0))):(rt=at[0]=e=null,it=at[1]=n=null)),fn(S,e,n)}let ut,dt,ft,pt,mt,ht,gt,_t,vt,yt;function bt(e,t,n,r,i,a){e??=Uf,n??=Cm,r??=`butt`,i??=Uf,a??=`round`,e!=ut&&(d.strokeStyle=ut=e),i!=dt&&(d.fillStyle=dt=i),t!=ft&&(d.lineWidth=ft=t),a!=mt&&(d.lineJoin=mt=a),r!=ht&&(d.lineCap=ht=r),n!=pt&&d.setLineDash(pt=n)}function xt(e,t,n,r){t!=dt&&(d.fillStyle=dt=t),e!=gt&&(d.font=gt=e),n!=_t&&(d.textAlign=_t=n),r!=vt&&(d.textBaseline=vt=r)}function St(e,t,n,i,a=0){if(i.length>0&&e.auto(r,st)&&(t==null||t.min==null)){let t=Lp(rt,0),r=Lp(it,i.length-1),o=n.min==null?kp(i,t,r,a,e.distr==3):[n.min,n.max];e.min=Jp(e.min,n.min=o[0]),e.max=Yp(e.max,n.max=o[1])}}let Ct={min:null,max:null};function wt(){for(let e in b){let t=b[e];j[e]==null&&(t.min==null||j[S]!=null&&t.auto(r,st))&&(j[e]=Ct)}for(let e in b){let t=b[e];j[e]==null&&t.from!=null&&j[t.from]!=null&&(j[e]=Ct)}j[S]!=null&&Rt(!0);let e={};for(let t in j){let n=j[t];if(n!=null){let a=e[t]=Nm(b[t],Am);if(n.min!=null)Pm(a,n);else if(t!=S||i==2){if(nt==0&&a.from==null){let e=a.range(r,null,null,t);a.min=e[0],a.max=e[1]}else a.min=nm,a.max=-1/0}}}if(nt>0){v.forEach((n,a)=>{if(i==1){let i=n.scale,o=j[i];if(o==null)return;let s=e[i];if(a==0){let e=s.range(r,s.min,s.max,i);s.min=e[0],s.max=e[1],rt=Cp(s.min,t[0]),it=Cp(s.max,t[0]),it-rt>1&&(t[0][rt]<s.min&&rt++,t[0][it]>s.max&&it--),n.min=ot[rt],n.max=ot[it]}else n.show&&n.auto&&St(s,o,n,t[a],n.sorted);n.idxs[0]=rt,n.idxs[1]=it}else if(a>0&&n.show&&n.auto){let[r,i]=n.facets,o=r.scale,s=i.scale,[c,l]=t[a],u=e[o],d=e[s];u!=null&&St(u,j[o],r,c,r.sorted),d!=null&&St(d,j[s],i,l,i.sorted),n.min=i.min,n.max=i.max}});for(let t in e){let n=e[t],i=j[t];if(n.from==null&&(i==null||i.min==null)){let e=n.range(r,n.min==nm?null:n.min,n.max==-1/0?null:n.max,t);n.min=e[0],n.max=e[1]}}}for(let t in e){let n=e[t];if(n.from!=null){let i=e[n.from];if(i.min==null)n.min=n.max=null;else{let e=n.range(r,i.min,i.max,t);n.min=e[0],n.max=e[1]}}}let n={},a=!1;for(let t in e){let r=e[t],i=b[t];if(i.min!=r.min||i.max!=r.max){i.min=r.min,i.max=r.max;let e=i.distr;i._min=e==3?Qp(i.min):e==4?tm(i.min,i.asinh):e==100?i.fwd(i.min):i.min,i._max=e==3?Qp(i.max):e==4?tm(i.max,i.asinh):e==100?i.fwd(i.max):i.max,n[t]=a=!0}}if(a){v.forEach((e,t)=>{i==2?t>0&&n.y&&(e._paths=null):n[e.scale]&&(e._paths=null)});for(let e in n)W=!0,qn(`setScale`,e);F&&P.left>=0&&(Ae=Me=!0)}for(let e in j)j[e]=null}function Tt(e){let t=im(rt-1,0,nt-1),n=im(it+1,0,nt-1);for(;e[t]==null&&t>0;)t--;for(;e[n]==null&&n<nt-1;)n++;return[t,n]}function Et(){if(nt>0){let e=v.some(e=>e._focus)&&yt!=Ve.alpha;e&&(d.globalAlpha=yt=Ve.alpha),v.forEach((e,n)=>{if(n>0&&e.show&&(Dt(n,!1),Dt(n,!0),e._paths==null)){let a=yt;yt!=e.alpha&&(d.globalAlpha=yt=e.alpha);let o=i==2?[0,t[n][0].length-1]:Tt(t[n]);e._paths=e.paths(r,n,o[0],o[1]),yt!=a&&(d.globalAlpha=yt=a)}}),v.forEach((e,t)=>{if(t>0&&e.show){let n=yt;yt!=e.alpha&&(d.globalAlpha=yt=e.alpha),e._paths!=null&&Ot(t,!1);{let n=e._paths==null?null:e._paths.gaps,i=e.points.show(r,t,rt,it,n),a=e.points.filter(r,t,i,n);(i||a)&&(e.points._paths=e.points.paths(r,t,rt,it,a),Ot(t,!0))}yt!=n&&(d.globalAlpha=yt=n),qn(`drawSeries`,t)}}),e&&(d.globalAlpha=yt=1)}}function Dt(e,t){let n=t?v[e].points:v[e];n._stroke=n.stroke(r,e),n._fill=n.fill(r,e)}function Ot(e,t){let n=t?v[e].points:v[e],{stroke:r,fill:i,clip:a,flags:o,_stroke:s=n._stroke,_fill:c=n._fill,_width:l=n.width}=n._paths;l=vm(l*ap,3);let u=null,f=l%2/2;t&&c==null&&(c=l>0?`#fff`:s);let p=n.pxAlign==1&&f>0;if(p&&d.translate(f,f),!t){let e=Te-l/2,t=Ee-l/2,n=De+l,r=Oe+l;u=new Path2D,u.rect(e,t,n,r)}t?At(s,l,n.dash,n.cap,c,r,i,o,a):kt(e,s,l,n.dash,n.cap,c,r,i,o,u,a),p&&d.translate(-f,-f)}function kt(e,n,i,a,o,s,c,l,u,d,f){let p=!1;u!=0&&x.forEach((m,h)=>{if(m.series[0]==e){let e=v[m.series[1]],g=t[m.series[1]],_=(e._paths||Sm).band;Tm(_)&&(_=m.dir==1?_[0]:_[1]);let y,b=null;e.show&&_&&Rp(g,rt,it)?(b=m.fill(r,h)||s,y=e._paths.clip):_=null,At(n,i,a,o,b,c,l,u,d,f,y,_),p=!0}}),p||At(n,i,a,o,s,c,l,u,d,f)}function At(e,t,n,r,i,a,o,s,c,l,u,f){bt(e,t,n,r,i),(c||l||f)&&(d.save(),c&&d.clip(c),l&&d.clip(l)),f?(s&3)==3?(d.clip(f),u&&d.clip(u),Mt(i,o),jt(e,a,t)):s&Eg?(Mt(i,o),d.clip(f),jt(e,a,t)):s&Tg&&(d.save(),d.clip(f),u&&d.clip(u),Mt(i,o),d.restore(),jt(e,a,t)):(Mt(i,o),jt(e,a,t)),(c||l||f)&&d.restore()}function jt(e,t,n){n>0&&(t instanceof Map?t.forEach((e,t)=>{d.strokeStyle=ut=t,d.stroke(e)}):t!=null&&e&&d.stroke(t))}function Mt(e,t){t instanceof Map?t.forEach((e,t)=>{d.fillStyle=dt=t,d.fill(e)}):t!=null&&e&&d.fill(t)}function Nt(e,t,n,i){let a=y[e],o;if(i<=0)o=[0,0];else{let s=a._space=a.space(r,e,t,n,i);o=__(t,n,a._incrs=a.incrs(r,e,t,n,i,s),i,s)}return a._found=o}function Pt(e,t,n,r,i,a,o,s,c,l){let u=o%2/2;h==1&&d.translate(u,u),bt(s,o,c,l,s),d.beginPath();let f,p,m,g,_=i+(r==0||r==3?-a:a);n==0?(p=i,g=_):(f=i,m=_);for(let r=0;r<e.length;r++)t[r]!=null&&(n==0?f=m=e[r]:p=g=e[r],d.moveTo(f,p),d.lineTo(m,g));d.stroke(),h==1&&d.translate(-u,-u)}function Ft(e){let t=!0;return y.forEach((n,i)=>{if(!n.show)return;let a=b[n.scale];if(a.min==null){n._show&&(t=!1,n._show=!1,Rt(!1));return}n._show||(t=!1,n._show=!0,Rt(!1));let o=n.side,s=o%2,{min:c,max:l}=a,[u,d]=Nt(i,c,l,s==0?z:B);if(d==0)return;let f=a.distr==2,p=n._splits=n.splits(r,i,c,l,u,d,f),m=a.distr==2?p.map(e=>ot[e]):p,h=a.distr==2?ot[p[1]]-ot[p[0]]:u,g=n._values=n.values(r,n.filter(r,m,i,d,h),i,d,h);n._rotate=o==2?n.rotate(r,g,i,d):0;let _=n._size;n._size=qp(n.size(r,g,i,e)),_!=null&&n._size!=_&&(t=!1)}),t}function It(e){let t=!0;return et.forEach((n,i)=>{let a=n(r,i,Ze,e);a!=tt[i]&&(t=!1),tt[i]=a}),t}function Lt(){for(let e=0;e<y.length;e++){let t=y[e];if(!t.show||!t._show)continue;let n=t.side,i=n%2,a,o,c=t.stroke(r,e),l=n==0||n==3?-1:1,[u,f]=t._found;if(t.label!=null){let s=t.labelGap*l,p=Kp((t._lpos+s)*ap);xt(t.labelFont[0],c,`center`,n==2?Rf:zf),d.save(),i==1?(a=o=0,d.translate(p,Kp(Ee+Oe/2)),d.rotate((n==3?-Up:Up)/2)):(a=Kp(Te+De/2),o=p);let m=am(t.label)?t.label(r,e,u,f):t.label;d.fillText(m,a,o),d.restore()}if(f==0)continue;let p=b[t.scale],m=i==0?De:Oe,h=i==0?Te:Ee,_=t._splits,v=p.distr==2?_.map(e=>ot[e]):_,x=p.distr==2?ot[_[1]]-ot[_[0]]:u,S=t.ticks,C=t.border,w=S.show?S.size:0,T=Kp(w*ap),E=Kp((t.alignTo==2?t._size-w-t.gap:t.gap)*ap),D=t._rotate*-Up/180,O=g(t._pos*ap),k=O+(T+E)*l;o=i==0?k:0,a=i==1?k:0;let A=t.font[0];xt(A,c,t.align==1?Bf:t.align==2?Vf:D>0?Bf:D<0?Vf:i==0?`center`:n==3?Vf:Bf,D||i==1?`middle`:n==2?Rf:zf);let j=t.font[1]*t.lineGap,M=_.map(e=>g(s(e,p,m,h))),N=t._values;for(let e=0;e<N.length;e++){let t=N[e];if(t!=null){i==0?a=M[e]:o=M[e],t=``+t;let n=t.indexOf(`
`)==-1?[t]:t.split(/\n/gm);for(let e=0;e<n.length;e++){let t=n[e];D?(d.save(),d.translate(a,o+e*j),d.rotate(D),d.fillText(t,0,0),d.restore()):d.fillText(t,a,o+e*j)}}}S.show&&Pt(M,S.filter(r,v,e,f,x),i,n,O,T,vm(S.width*ap,3),S.stroke(r,e),S.dash,S.cap);let ee=t.grid;ee.show&&Pt(M,ee.filter(r,v,e,f,x),i,i==0?2:1,i==0?Ee:Te,i==0?Oe:De,vm(ee.width*ap,3),ee.stroke(r,e),ee.dash,ee.cap),C.show&&Pt([O],[1],+(i==0),i==0?1:2,i==1?Ee:Te,i==1?Oe:De,vm(C.width*ap,3),C.stroke(r,e),C.dash,C.cap)}qn(`drawAxes`)}function Rt(e){v.forEach((t,n)=>{n>0&&(t._paths=null,e&&(i==1?(t.min=null,t.max=null):t.facets.forEach(e=>{e.min=null,e.max=null})))})}let zt=!1,Bt=!1,Vt=[];function Ht(){Bt=!1;for(let e=0;e<Vt.length;e++)qn(...Vt[e]);Vt.length=0}function Ut(){zt||=(Bm(G),!0)}function Wt(e,t=!1){zt=!0,Bt=t,e(r),G(),t&&Vt.length>0&&queueMicrotask(Ht)}r.batch=Wt;function G(){if(ke&&=(wt(),!1),W&&=(Fe(),!1),U){if(up(p,Bf,xe),up(p,Rf,V),up(p,If,z),up(p,Lf,B),up(m,Bf,xe),up(m,Rf,V),up(m,If,z),up(m,Lf,B),up(f,If,be),up(f,Lf,R),u.width=Kp(be*ap),u.height=Kp(R*ap),y.forEach(({_el:e,_show:t,_size:n,_pos:r,side:i})=>{if(e!=null){if(t){let t=i===3||i===0?n:0,a=i%2==1;up(e,a?`left`:`top`,r-t),up(e,a?`width`:`height`,n),up(e,a?`top`:`left`,a?V:xe),up(e,a?`height`:`width`,a?B:z),lp(e,wf)}else cp(e,wf)}}),ut=dt=ft=mt=ht=gt=_t=vt=pt=null,yt=1,jn(!0),xe!=Se||V!=Ce||z!=H||B!=we){Rt(!1);let e=z/H,t=B/we;if(F&&!Ae&&P.left>=0){P.left*=e,P.top*=t,qt&&mp(qt,Kp(P.left),0,z,B),Jt&&mp(Jt,0,Kp(P.top),z,B);for(let n=0;n<We.length;n++){let r=We[n];r!=null&&(Ge[n]*=e,Ke[n]*=t,mp(r,qp(Ge[n]),qp(Ke[n]),z,B))}}if(cn.show&&!je&&cn.left>=0&&cn.width>0){cn.left*=e,cn.width*=e,cn.top*=t,cn.height*=t;for(let e in Pn)up(ln,e,cn[e])}Se=xe,Ce=V,H=z,we=B}qn(`setSize`),U=!1}be>0&&R>0&&(d.clearRect(0,0,u.width,u.height),qn(`drawClear`),w.forEach(e=>e()),qn(`draw`)),cn.show&&je&&(un(cn),je=!1),F&&Ae&&(kn(null,!0,!1),Ae=!1),ie.show&&ie.live&&Me&&(Dn(),Me=!1),c||(c=!0,r.status=1,qn(`ready`)),st=!1,zt=!1}r.redraw=(e,t)=>{W=t||!1,e===!1?Ut():fn(S,D.min,D.max)};function K(e,n){let i=b[e];if(i.from==null){if(nt==0){let t=i.range(r,n.min,n.max,e);n.min=t[0],n.max=t[1]}if(n.min>n.max){let e=n.min;n.min=n.max,n.max=e}if(nt>1&&n.min!=null&&n.max!=null&&n.max-n.min<1e-16)return;e==S&&i.distr==2&&nt>0&&(n.min=Cp(n.min,t[0]),n.max=Cp(n.max,t[0]),n.min==n.max&&n.max++),j[e]=n,ke=!0,Ut()}}r.setScale=K;let Gt,Kt,qt,Jt,Yt,Xt,Zt,Qt,$t,en,tn,nn,rn=!1,an=P.drag,on=an.x,sn=an.y;F&&(P.x&&(Gt=fp(Ef,m)),P.y&&(Kt=fp(Df,m)),D.ori==0?(qt=Gt,Jt=Kt):(qt=Kt,Jt=Gt),tn=P.left,nn=P.top);let cn=r.select=Pm({show:!0,over:!0,left:0,width:0,top:0,height:0},e.select),ln=cn.show?fp(Tf,cn.over?m:p):null;function un(e,t){if(cn.show){for(let t in e)cn[t]=e[t],t in Pn&&up(ln,t,e[t]);t!==!1&&qn(`setSelect`)}}r.setSelect=un;function dn(e){if(v[e].show)ae&&lp(ce[e],wf);else if(ae&&cp(ce[e],wf),F){let t=Ue?We[0]:We[e];t!=null&&mp(t,-10,-10,z,B)}}function fn(e,t,n){K(e,{min:t,max:n})}function pn(e,t,n,a){t.focus!=null&&Sn(e),t.show!=null&&v.forEach((n,r)=>{r>0&&(e==r||e==null)&&(n.show=t.show,dn(r),i==2?(fn(n.facets[0].scale,null,null),fn(n.facets[1].scale,null,null)):fn(n.scale,null,null),Ut())}),n!==!1&&qn(`setSeries`,e,t),a&&Qn(`setSeries`,r,e,t)}r.setSeries=pn;function mn(e,t){Pm(x[e],t)}function hn(e,t){e.fill=om(e.fill||null),e.dir=Lp(e.dir,-1),t??=x.length,x.splice(t,0,e)}function gn(e){e==null?x.length=0:x.splice(e,1)}r.addBand=hn,r.setBand=mn,r.delBand=gn;function _n(e,t){v[e].alpha=t,F&&We[e]!=null&&(We[e].style.opacity=t),ae&&ce[e]&&(ce[e].style.opacity=t)}let vn,yn,bn,xn={focus:!0};function Sn(e){if(e!=bn){let t=e==null,n=Ve.alpha!=1;v.forEach((r,a)=>{if(i==1||a>0){let i=t||a==0||a==e;r._focus=t?null:i,n&&_n(a,i?1:Ve.alpha)}}),bn=e,n&&Ut()}}ae&&He&&ve(Jf,L,e=>{P._lock||(ze(e),bn!=null&&pn(null,xn,!0,Yn.setSeries))});function Cn(e,t,n){let r=b[t];n&&(e=e/ap-(r.ori==1?V:xe));let i=z;r.ori==1&&(i=B,e=i-e),r.dir==-1&&(e=i-e);let a=r._min,o=r._max,s=e/i,c=a+(o-a)*s,l=r.distr;return l==3?Xp(10,c):l==4?em(c,r.asinh):l==100?r.bwd(c):c}function q(e,n){return Cp(Cn(e,S,n),t[0],rt,it)}r.valToIdx=e=>Cp(e,t[0]),r.posToIdx=q,r.posToVal=Cn,r.valToPos=(e,t,n)=>b[t].ori==0?a(e,b[t],n?De:z,n?Te:0):o(e,b[t],n?Oe:B,n?Ee:0),r.setCursor=(e,t,n)=>{tn=e.left,nn=e.top,kn(null,t,n)};function wn(e,t){up(ln,Bf,cn.left=e),up(ln,If,cn.width=t)}function J(e,t){up(ln,Rf,cn.top=e),up(ln,Lf,cn.height=t)}let Tn=D.ori==0?wn:J,En=D.ori==1?wn:J;function Y(){if(ae&&ie.live)for(let e=+(i==2);e<v.length;e++){if(e==0&&de)continue;let t=ie.values[e],n=0;for(let r in t)le[e][n++].firstChild.nodeValue=t[r]}}function Dn(e,t){if(e!=null&&(e.idxs?e.idxs.forEach((e,t)=>{re[t]=e}):Dm(e.idx)||re.fill(e.idx),ie.idx=re[0]),ae&&ie.live){for(let e=0;e<v.length;e++)(e>0||i==1&&!de)&&On(e,re[e]);Y()}Me=!1,t!==!1&&qn(`setLegend`)}r.setLegend=Dn;function On(e,n){let i=v[e],a=e==0&&O==2?ot:t[e],o;de?o=i.values(r,e,n)??fe:(o=i.value(r,n==null?null:a[n],e,n),o=o==null?fe:{_:o}),ie.values[e]=o}function kn(e,n,a){$t=tn,en=nn,[tn,nn]=P.move(r,tn,nn),P.left=tn,P.top=nn,F&&(qt&&mp(qt,Kp(tn),0,z,B),Jt&&mp(Jt,0,Kp(nn),z,B));let o,s=rt>it;vn=nm,yn=null;let c=D.ori==0?z:B,l=D.ori==1?z:B;if(tn<0||nt==0||s){o=P.idx=null;for(let e=0;e<v.length;e++){let t=We[e];t!=null&&mp(t,-10,-10,z,B)}He&&pn(null,xn,!0,e==null&&Yn.setSeries),ie.live&&(re.fill(o),Me=!0)}else{let e,n,a;i==1&&(e=D.ori==0?tn:nn,n=Cn(e,S),o=P.idx=Cp(n,t[0],rt,it),a=k(t[0][o],D,c,0));let s=-10,u=-10,d=0,f=0,p=!0,m=``,h=``;for(let e=+(i==2);e<v.length;e++){let g=v[e],_=re[e],y=_==null?null:i==1?t[e][_]:t[e][1][_],x=P.dataIdx(r,e,o,n),S=x==null?null:i==1?t[e][x]:t[e][1][x];if(Me=Me||S!=y||x!=_,re[e]=x,e>0&&g.show){let n=x==null?-10:x==o?a:k(i==1?t[0][x]:t[e][0][x],D,c,0),_=S==null?-10:A(S,i==1?b[g.scale]:b[g.facets[1].scale],l,0);if(He&&S!=null){let t=D.ori==1?tn:nn,n=Wp(Ve.dist(r,e,x,_,t));if(n<vn){let r=Ve.bias;if(r!=0){let i=Cn(t,g.scale),a=S>=0?1:-1,o=i>=0?1:-1;o==a&&(o==1?r==1?S>=i:S<=i:r==1?S<=i:S>=i)&&(vn=n,yn=e)}else vn=n,yn=e}}if(Me||Ue){let t,i;D.ori==0?(t=n,i=_):(t=_,i=n);let a,o,c,l,g,v,y=!0,b=Be.bbox;if(b!=null){y=!1;let t=b(r,e);c=t.left,l=t.top,a=t.width,o=t.height}else c=t,l=i,a=o=Be.size(r,e);if(v=Be.fill(r,e),g=Be.stroke(r,e),Ue)e==yn&&vn<=Ve.prox&&(s=c,u=l,d=a,f=o,p=y,m=v,h=g);else{let t=We[e];t!=null&&(Ge[e]=c,Ke[e]=l,vp(t,a,o,y),gp(t,v,g),mp(t,qp(c),qp(l),z,B))}}}}if(Ue){let e=Ve.prox;if(Me||(bn==null?vn<=e:vn>e||yn!=bn)){let e=We[0];e!=null&&(Ge[0]=s,Ke[0]=u,vp(e,d,f,p),gp(e,m,h),mp(e,qp(s),qp(u),z,B))}}}if(cn.show&&rn){if(e!=null){let[t,n]=Yn.scales,[r,i]=Yn.match,[a,o]=e.cursor.sync.scales,s=e.cursor.drag;if(on=s._x,sn=s._y,on||sn){let{left:s,top:u,width:d,height:f}=e.select,p=e.scales[a].ori,m=e.posToVal,h,g,_,v,y,x=t!=null&&r(t,a),S=n!=null&&i(n,o);x&&on?(p==0?(h=s,g=d):(h=u,g=f),_=b[t],v=k(m(h,a),_,c,0),y=k(m(h+g,a),_,c,0),Tn(Jp(v,y),Wp(y-v))):Tn(0,c),S&&sn?(p==1?(h=s,g=d):(h=u,g=f),_=b[n],v=A(m(h,o),_,l,0),y=A(m(h+g,o),_,l,0),En(Jp(v,y),Wp(y-v))):En(0,l)}else Fn()}else{let e=Wp($t-Yt),t=Wp(en-Xt);if(D.ori==1){let n=e;e=t,t=n}on=an.x&&e>=an.dist,sn=an.y&&t>=an.dist;let n=an.uni;n==null?an.x&&an.y&&(on||sn)&&(on=sn=!0):on&&sn&&(on=e>=n,sn=t>=n,!on&&!sn&&(t>e?sn=!0:on=!0));let r,i;on&&(D.ori==0?(r=Zt,i=tn):(r=Qt,i=nn),Tn(Jp(r,i),Wp(i-r)),sn||En(0,l)),sn&&(D.ori==1?(r=Zt,i=tn):(r=Qt,i=nn),En(Jp(r,i),Wp(i-r)),on||Tn(0,c)),!on&&!sn&&(Tn(0,0),En(0,0))}}if(an._x=on,an._y=sn,e==null){if(a){if(Xn!=null){let[e,t]=Yn.scales;Yn.values[0]=e==null?null:Cn(D.ori==0?tn:nn,e),Yn.values[1]=t==null?null:Cn(D.ori==1?tn:nn,t)}Qn(Wf,r,tn,nn,z,B,o)}if(He){let e=a&&Yn.setSeries,t=Ve.prox;bn==null?vn<=t&&pn(yn,xn,!0,e):vn>t?pn(null,xn,!0,e):yn!=bn&&pn(yn,xn,!0,e)}}Me&&(ie.idx=o,Dn()),n!==!1&&qn(`setCursor`)}let An=null;Object.defineProperty(r,"rect",{get(){return An??jn(!1),An}});function jn(e=!1){e?An=null:(An=m.getBoundingClientRect(),qn(`syncRect`,An))}function Mn(e,t,n,r,i,a,o){P._lock||rn&&e!=null&&e.movementX==0&&e.movementY==0||(Nn(e,t,n,r,i,a,o,!1,e!=null),e==null?kn(t,!0,!1):kn(null,!0,!0))}function Nn(e,t,n,i,a,o,c,l,u){if(An??jn(!1),ze(e),e!=null)n=e.clientX-An.left,i=e.clientY-An.top;else{if(n<0||i<0){tn=-10,nn=-10;return}let[e,r]=Yn.scales,c=t.cursor.sync,[l,u]=c.values,[d,f]=c.scales,[p,m]=Yn.match,h=t.axes[0].side%2==1,g=D.ori==0?z:B,_=D.ori==1?z:B,v=h?o:a,y=h?a:o,x=h?i:n,S=h?n:i;if(n=d==null?x/v*g:p(e,d)?s(l,b[e],g,0):-10,i=f==null?S/y*_:m(r,f)?s(u,b[r],_,0):-10,D.ori==1){let e=n;n=i,i=e}}u&&(t==null||t.cursor.event.type==Wf)&&((n<=1||n>=z-1)&&(n=hm(n,z)),(i<=1||i>=B-1)&&(i=hm(i,B))),l?(Yt=n,Xt=i,[Zt,Qt]=P.move(r,n,i)):(tn=n,nn=i)}let Pn={width:0,height:0,left:0,top:0};function Fn(){un(Pn,!1)}let In,Ln,Rn,zn;function Bn(e,t,n,i,a,o,s){rn=!0,on=sn=an._x=an._y=!1,Nn(e,t,n,i,a,o,s,!0,!1),e!=null&&(ve(Kf,np,Vn,!1),Qn(Gf,r,Zt,Qt,z,B,null));let{left:c,top:l,width:u,height:d}=cn;In=c,Ln=l,Rn=u,zn=d}function Vn(e,t,n,i,a,o,s){rn=an._x=an._y=!1,Nn(e,t,n,i,a,o,s,!1,!0);let{left:c,top:l,width:u,height:d}=cn,f=u>0||d>0,p=In!=c||Ln!=l||Rn!=u||zn!=d;if(f&&p&&un(cn),an.setScale&&f&&p){let e=c,t=u,n=l,r=d;if(D.ori==1&&(e=l,t=d,n=c,r=u),on&&fn(S,Cn(e,S),Cn(e+t,S)),sn)for(let e in b){let t=b[e];e!=S&&t.from==null&&t.min!=nm&&fn(e,Cn(n+r,e),Cn(n,e))}Fn()}else P.lock&&(P._lock=!P._lock,kn(t,!0,e!=null));e!=null&&(ye(Kf,np),Qn(Kf,r,tn,nn,z,B,null))}function Hn(e,t,n,r,i,a,o){if(P._lock)return;ze(e);let s=rn;if(rn){let e=!0,t=!0,n,r;D.ori==0?(n=on,r=sn):(n=sn,r=on),n&&r&&(e=tn<=10||tn>=z-10,t=nn<=10||nn>=B-10),n&&e&&(tn=tn<Zt?0:z),r&&t&&(nn=nn<Qt?0:B),kn(null,!0,!0),rn=!1}tn=-10,nn=-10,re.fill(null),kn(null,!0,!0),s&&(rn=s)}function Un(e,t,n,i,a,o,s){P._lock||(ze(e),lt(),Fn(),e!=null&&Qn(Yf,r,tn,nn,z,B,null))}function Wn(){y.forEach(y_),Ne(r.width,r.height,!0)}xp($f,rp,Wn);let Gn={};Gn.mousedown=Bn,Gn.mousemove=Mn,Gn.mouseup=Vn,Gn.dblclick=Un,Gn.setSeries=(e,t,n,i)=>{let a=Yn.match[2];n=a(r,t,n),n!=-1&&pn(n,i,!0,!1)},F&&(ve(Gf,m,Bn),ve(Wf,m,Mn),ve(qf,m,e=>{ze(e),jn(!1)}),ve(Jf,m,Hn),ve(Yf,m,Un),r_.add(r),r.syncRect=jn);let Kn=r.hooks=e.hooks||{};function qn(e,t,n){Bt?Vt.push([e,t,n]):e in Kn&&Kn[e].forEach(e=>{e.call(null,r,t,n)})}(e.plugins||[]).forEach(e=>{for(let t in e.hooks)Kn[t]=(Kn[t]||[]).concat(e.hooks[t])});let Jn=(e,t,n)=>n,Yn=Pm({key:null,setSeries:!1,filters:{pub:dm,sub:dm},scales:[S,v[1]?v[1].scale:null],match:[fm,fm,Jn],values:[null,null]},P.sync);Yn.match.length==2&&Yn.match.push(Jn),P.sync=Yn;let Xn=Yn.key,Zn=wg(Xn);function Qn(e,t,n,r,i,a,o){Yn.filters.pub(e,t,n,r,i,a,o)&&Zn.pub(e,t,n,r,i,a,o)}Zn.sub(r);function $n(e,t,n,r,i,a,o){Yn.filters.sub(e,t,n,r,i,a,o)&&Gn[e](null,t,n,r,i,a,o)}r.pub=$n;function er(){Zn.unsub(r),r_.delete(r),_e.clear(),Sp($f,rp,Wn),l.remove(),L?.remove(),qn(`destroy`)}r.destroy=er;function tr(){qn(`init`,e,t),ct(t||e.data,!1),j[S]?K(S,j[S]):lt(),je=cn.show&&(cn.width>0||cn.height>0),Ae=Me=!0,Ne(e.width,e.height)}return v.forEach(Je),y.forEach(Qe),n?n instanceof HTMLElement?(n.appendChild(l),tr()):n(r,tr):tr(),r}b_.assign=Pm,b_.fmtNum=Vp,b_.rangeNum=Ip,b_.rangeLog=Ap,b_.rangeAsinh=jp,b_.orient=Dg,b_.pxRatio=ap,b_.join=zm,b_.fmtDate=Qm,b_.tzDate=eh,b_.sync=wg;{b_.addGap=Mg,b_.clipGaps=jg;let e=b_.paths={points:Kg};e.linear=Xg,e.stepped=Zg,e.bars=$g,e.spline=t_}var x_=22;function S_(e,t,n,r=400){let i=Math.hypot(n[0]-t[0],n[1]-t[1]),a=r=>e.at(t[0]+r*(n[0]-t[0]),t[1]+r*(n[1]-t[1])),o=[],s=[],c=(e,t)=>{o.push(e),s.push(t)},l=(e,t,n,r,i)=>{if(t?.element===r?.element)return;if(i===0){c(e,t),c(n,r);return}let o=(e+n)/2,s=a(o);l(e,t,o,s,i-1),l(o,s,n,r,i-1)},u=a(0);c(0,u);for(let e=1;e<=r;e++){let t=a(e/r);l((e-1)/r,u,e/r,t,x_),c(e/r,t),u=t}let d=o.map((e,t)=>t===0||e>o[t-1]);return{start:t,end:n,s:o.filter((e,t)=>d[t]).map(e=>e*i),spots:s.filter((e,t)=>d[t])}}function C_(e,t,n,r,i){return i.spots.map(i=>i?w(e,t,n,r,i).value:null)}function w_(e,t){let n=null,r=null;return t.forEach((t,i)=>{t!==null&&((!n||t<n[1])&&(n=[e[i],t]),(!r||t>r[1])&&(r=[e[i],t]))}),n&&r?{min:n,max:r}:null}function T_(e,t){let[n,r]=[e??0,t??0];if(n>0&&n<.7*r&&(n=0),r<0&&r>.7*n&&(r=0),n===r)return[n-(.1*Math.abs(n)||1),r+(.1*Math.abs(r)||1)];let i=.08*(r-n);return[n===0?0:n-i,r===0?0:r+i]}function E_(e){return e===`settlement`||e.startsWith(`moment`)||/^(m_|bottom|top)/.test(e)}var D_={light:[`#0072b2`,`#d55e00`,`#00795b`,`#b0568c`,`#8a6d00`,`#2a8fc4`,`#5a4fcf`,`#6b6b6b`],dark:[`#56b4e9`,`#f0883e`,`#2bc49a`,`#e29cc4`,`#e6c229`,`#9ad0f5`,`#a79bff`,`#b5b5b5`]},O_=[7,4],k_=`system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", "Liberation Sans", "DejaVu Sans", sans-serif`,A_=class{onPlace;element=Z(`div`,{class:`gs-chart`});plot=null;section=null;samples=null;curves=[];theme=md();resized;constructor(e){e.append(this.element),this.resized=new ResizeObserver(()=>this.resize()),this.resized.observe(this.element)}show(e){let t=this.section;this.section=e,t&&e&&t.locator===e.locator&&String([t.start,t.end])===String([e.start,e.end])||(this.samples=e?S_(e.locator,e.start,e.end):null),this.curves=e&&this.samples?e.choices.map(t=>C_(e.scene,e.locator,t,e.field,this.samples)):[],this.draw()}setTheme(e){this.theme=e,this.draw()}snapshot(e,t,n){if(!this.section||!this.samples||!this.crosses())return null;let r=n/b_.pxRatio,i=Z(`div`,{class:`gs-chart gs-chart-away`});document.body.append(i);let a=new b_(this.options(e*r,t*r,r,`light`),[this.samples.s,...this.curves],i);a.batch(()=>void 0);let o=document.createElement(`canvas`);return[o.width,o.height]=[a.ctx.canvas.width,a.ctx.canvas.height],o.getContext(`2d`).drawImage(a.ctx.canvas,0,0),o.style.width=`${e}px`,a.destroy(),i.remove(),o}names(){let{section:e}=this;return e?e.choices.map((t,n)=>({name:x(e.scene,t),colour:D_.light[n%D_.light.length]})):[]}dispose(){this.resized.disconnect(),this.plot?.destroy(),this.element.remove()}crosses(){return this.curves.some(e=>w_(this.samples.s,e)!==null)}resize(){let{clientWidth:e,clientHeight:t}=this.element;this.plot&&e&&t&&this.plot.setSize({width:e,height:this.room()})}room(){return Math.max(this.element.clientHeight-(this.element.querySelector(`.u-legend`)?.offsetHeight??26),90)}draw(){this.plot?.destroy(),this.plot=null,this.element.replaceChildren();let{section:e,samples:t}=this;if(this.onPlace?.(null),!e||!t)return;if(!this.crosses()){this.element.append(Z(`p`,{class:`gs-chart-none`},`The section does not cross the plate.`));return}let n=Math.max(this.element.clientWidth,200);this.plot=new b_(this.options(n,Math.max(this.element.clientHeight-26,90),1,this.theme),[t.s,...this.curves],this.element),this.resize()}options(e,t,n,r){let{scene:i,field:a,choices:o}=this.section,s=p(i,a),c=vu(r),l=`${12*n}px ${k_}`,u={stroke:c.ink,font:l,labelFont:l,gap:4*n,grid:{stroke:c.line,width:.7*n},ticks:{stroke:c.line,width:n,size:5*n}},d=D_[r];return{width:e,height:t,scales:{x:{time:!1,range:()=>[0,Math.max(this.length(),1e-9)]},y:{dir:E_(a)?-1:1,range:(e,t,n)=>T_(t,n)}},axes:[{...u,label:`distance s along the section [m]`,labelSize:18*n,size:26*n,space:60*n,values:(e,t)=>t.map(e=>nu(e,6))},{...u,label:`${Iu(s.symbol)} [${s.unit}]`,labelSize:20*n,size:50*n,space:26*n,values:(e,t)=>t.map(e=>nu(e,6))}],legend:{show:n===1},cursor:{drag:{x:!1,y:!1},points:{size:7}},padding:[10*n,14*n,0,0],series:[{label:`s`,value:(e,t)=>t===null?`–`:`${t.toFixed(2)} m`},...o.map((e,t)=>({label:x(i,e)||Iu(s.symbol),stroke:d[t%d.length],...o.length===1?{fill:`${d[0]}1c`}:{},width:1.7*n,...t>=d.length?{dash:O_.map(e=>e*n)}:{},points:{show:!1},value:(e,t)=>t===null?`–`:`${tu(t)} ${s.unit}`}))],hooks:{draw:[e=>this.mark(e,n,c)],setCursor:[e=>{n===1&&this.point(e)}]}}}length(){let{start:e,end:t}=this.section;return Math.hypot(t[0]-e[0],t[1]-e[1])}point(e){let{idx:t}=e.cursor,n=t==null?void 0:this.samples?.s[t];if(n===void 0||(e.cursor.left??-1)<0){this.onPlace?.(null);return}let{start:r,end:i}=this.section,a=n/(this.length()||1);this.onPlace?.([r[0]+a*(i[0]-r[0]),r[1]+a*(i[1]-r[1])])}mark(e,t,n){let{ctx:r,bbox:i}=e,a=b_.pxRatio*t,{scene:o,choices:s}=this.section;r.save();let c=Math.round(e.valToPos(0,`y`,!0));c>=i.top&&c<=i.top+i.height&&(r.strokeStyle=n.ink,r.lineWidth=a,r.beginPath(),r.moveTo(i.left,c),r.lineTo(i.left+i.width,c),r.stroke());let[l,u]=[null,null];this.curves.forEach((e,t)=>{let n=w_(this.samples.s,e);n&&((!l||n.min[1]<l.value)&&(l={s:n.min[0],value:n.min[1],curve:t}),(!u||n.max[1]>u.value)&&(u={s:n.max[0],value:n.max[1],curve:t}))}),r.font=`600 ${12*a}px ${k_}`,r.lineJoin=`round`,r.textAlign=`left`,r.textBaseline=`alphabetic`;for(let t of[u,l]){if(!t)continue;let[c,l]=[e.valToPos(t.s,`x`,!0),e.valToPos(t.value,`y`,!0)];r.beginPath(),r.arc(c,l,3.5*a,0,2*Math.PI),r.fillStyle=n.ink,r.fill();let d=s[t.curve],f=s.length>1&&!v(d)?` (${o.head.combinations[d]?.number??``})`:``,p=`${t===u?`max`:`min`} ${tu(t.value)}${f}`,m=r.measureText(p).width,h=c+8*a+m>i.left+i.width?c-8*a-m:c+8*a,g=Math.min(Math.max(l-6*a,i.top+12*a),i.top+i.height-4*a);r.strokeStyle=n.halo,r.lineWidth=3*a,r.strokeText(p,h,g),r.fillStyle=n.ink,r.fillText(p,h,g)}r.restore()}},j_=class{element=Z(`div`,{class:`gs-legend`});constructor(e){e.append(this.element)}show(e,t){let{element:n}=this;if(n.replaceChildren(),n.hidden=!e,!e)return;let{field:r,scale:i}=e;n.append(Z(`div`,{class:`gs-legend-title`,title:r.meaning},Fu(r.symbol),` [${r.unit}]`)),t&&t.head.combinations.length>1&&n.append(Z(`div`,{class:`gs-legend-of`},x(t,e.choice)));let a=Z(`div`,{class:`gs-legend-bar`,role:`img`,"aria-label":`Colours from ${tu(i.levels[0])} to ${tu(i.levels[i.levels.length-1])} ${r.unit}`}),o=i.colours.length,s=M_(i),[c,l]=[N_(e),P_(e)];c&&a.append(Z(`div`,{class:`gs-legend-band gs-legend-beyond`,style:`background:${au(i.over)}`},Z(`span`,{},`> ${s[o]}`)));for(let e=o-1;e>=0;e--){let t=Z(`div`,{class:`gs-legend-band`,style:`background:${au(i.colours[e])}`});(e<o-1||!c)&&t.append(Z(`span`,{},s[e+1])),e===0&&!l&&t.append(Z(`span`,{class:`gs-legend-last`},s[0])),a.append(t)}l&&a.append(Z(`div`,{class:`gs-legend-band gs-legend-beyond`,style:`background:${au(i.under)}`},Z(`span`,{},s[0]))),n.append(a);let u=Z(`div`,{class:`gs-legend-notes`});u.append(Z(`div`,{},`largest ${tu(i.max)}`),Z(`div`,{},`smallest ${tu(i.min)}`));let d=r.name===`pressure`&&t?f(t,e.choice):null;d&&u.append(Z(`div`,{},`edge line force up to ${tu(d[0])} kN/m`)),c&&u.append(Z(`div`,{},`above the scale: up to ${tu(i.max)} ${r.unit}`)),l&&u.append(Z(`div`,{},`below the scale: down to ${tu(i.min)} ${r.unit}`)),e.lifted&&u.append(Z(`div`,{},Z(`span`,{class:`gs-legend-hatch`}),typeof e.choice==`number`?`no contact`:`no contact in some combination`)),n.append(u)}};function M_({levels:e,origin:t,step:n}){let r=e.map((e,r)=>Number((t+r*n).toPrecision(12)));return ru(r).map((t,i)=>Math.abs(r[i]-e[i])>1e-9*n?tu(e[i]):t)}function N_({scale:e}){return e.max>e.levels[e.levels.length-1]+Kl*e.step}function P_({scale:e}){return e.min<e.levels[0]-Kl*e.step}var F_=class{element=Z(`div`,{class:`gs-values`,"aria-live":`polite`});onField;constructor(e){e.append(this.element),this.hint()}show(e,t,n,r,i){let{element:a}=this;if(!e||!t||!r)return this.hint();a.replaceChildren();let[o,s]=r;a.append(Z(`div`,{class:`gs-values-at`},`x ${L_(o)} m, y ${L_(s)} m`));let c=t.at(o,s);if(!c){a.append(Z(`p`,{},`This point is not on the plate.`));return}let l=v(n);a.append(Z(`div`,{class:`gs-values-of`},x(e,n)));let d=Z(`tbody`,{});for(let r of u(e)){let a=w(e,t,n,r.name,c),o=Z(`tr`,{title:r.meaning},Z(`th`,{scope:`row`},Fu(r.symbol)),Z(`td`,{},tu(a.value)),Z(`td`,{class:`gs-unit`},r.unit));l&&o.append(Z(`td`,{class:`gs-from`,title:e.head.combinations[a.from]?.name??``},`(${e.head.combinations[a.from]?.number??``})`)),r.name===i&&o.classList.add(`gs-chosen`),this.onField&&(o.tabIndex=0,o.addEventListener(`click`,()=>this.onField?.(r.name)),o.addEventListener(`keydown`,e=>{e.key===`Enter`&&this.onField?.(r.name)})),d.append(o)}if(!l){let r=r=>w(e,t,n,r,c).value;u(e).some(e=>e.name===`m_1`)&&d.append(Z(`tr`,{title:`direction of the strips that m_1 bends, from x`},Z(`th`,{scope:`row`},Fu(`phi_1`)),Z(`td`,{},tu(h(r(`moment_x`),r(`moment_y`),r(`moment_xy`)),3)),Z(`td`,{class:`gs-unit`},`°`)))}a.append(Z(`table`,{},d));let f=Z(`div`,{class:`gs-values-notes`}),p=T(e,t,n,c);p!==null&&f.append(Z(`div`,{},`contact: ${p?`yes`:l?`not in every combination`:`no`}`));let m=I_(e,c.element);m&&f.append(Z(`div`,{},m)),l&&f.append(Z(`div`,{class:`gs-screen`},`In brackets: the number of the combination that governs; hold the pointer over it for its name.`)),a.append(f)}hint(){this.element.replaceChildren(Z(`p`,{class:`gs-values-hint`},`Click on the plate to read all values there.`))}};function I_(e,t){let{plan:n}=e.head,r=e.mesh.section?.[t];if(r===void 0)return``;let i=r>0?n.zones[r-1]:void 0,a=i?i.thickness:n.thickness,o=i?i.name??`zone ${r}`:`plate`;return a===void 0?`section: ${o}`:`section: ${o}, t = ${nu(a*1e3)} mm`}function L_(e){return e.toFixed(3).replace(/-/,`−`)}function R_(e,t,n){let r=u(t),i=e=>Z(`option`,{value:e.name,title:e.meaning},`${Iu(e.symbol)} \u2013 ${e.meaning.split(/[,(]/)[0].trim()}`);e.replaceChildren(Z(`optgroup`,{label:`Results`},...r.filter(e=>!e.derived).map(i)),Z(`optgroup`,{label:`Derived moments`},...r.filter(e=>e.derived).map(i)));let a=r.find(e=>e.name===n)??r[0];return a&&(e.value=a.name),a?.name??``}function z_(e,t,n){let{combinations:r,left_out:i}=t.head,a=b(t),o=[];a.length&&o.push(Z(`optgroup`,{label:`Envelopes`},...a.map(e=>Z(`option`,{value:e},x(t,e)))));let s=r.map((e,n)=>{let r=e.refused===null?e.values===null?i.includes(e.name)?` (left out)`:` (no values)`:e.certified?``:` (not certified)`:` (no equilibrium)`;return Z(`option`,{value:n,disabled:e.values===null,title:e.refused??``},x(t,n)+r)});o.push(...a.length?[Z(`optgroup`,{label:`Combinations`},...s)]:s),e.replaceChildren(...o);let c=(n===void 0?void 0:[...e.options].find(e=>e.value===String(n)&&!e.disabled))??[...e.options].find(e=>!e.disabled&&/^\d+$/.test(e.value));return c?(e.value=c.value,S(c.value)):null}var B_=class extends Error{},V_=class extends Error{},H_=class extends Error{state;constructor(e){super(`the document has changed meanwhile`),this.state=e}},U_=class extends Error{status;kind;url;constructor(e,t,n=``,r=``){super(e),this.status=t,this.kind=n,this.url=r}},W_=15e3,G_=class{token;constructor(e){this.token=e}setToken(e){this.token=e}state=()=>this.json(`state`);schema=()=>this.json(`schema`);edit=(e,t)=>this.json(`edits`,{...e,base:t});undo=()=>this.json(`undo`,{});redo=()=>this.json(`redo`,{});save=(e,t)=>this.json(`save`,e===null?{over:t}:{file:e,over:t});open=e=>this.json(`open`,{file:e});fresh=()=>this.json(`new`,{});restore=e=>this.json(`restore`,{take:e});files=e=>this.json(e===null?`files`:`files?folder=${encodeURIComponent(e)}`);solve=async()=>(await this.json(`solve`,{})).run;cancel=async()=>void await this.json(`cancel`,{});autosolve=async e=>void await this.json(`autosolve`,{on:e});summary=e=>this.json(`results/${e}/summary`);scene=async e=>(await this.ask(`results/${e}/scene`,void 0,12e4)).arrayBuffer();reportAddress=e=>`api/results/${e}/report?token=${encodeURIComponent(this.token)}`;eventsAddress=()=>`api/events?token=${encodeURIComponent(this.token)}`;async json(e,t){return await(await this.ask(e,t)).json()}async ask(e,t,n=W_){let r;try{r=await fetch(`api/${e}`,{method:t===void 0?`GET`:`POST`,headers:{"X-Groundslab-Token":this.token,...t===void 0?{}:{"Content-Type":`application/json`}},...t===void 0?{}:{body:JSON.stringify(t)},signal:AbortSignal.timeout(n)})}catch(e){throw new B_(String(e))}if(!r.ok)throw await K_(r);return r}};async function K_(e){if(e.status===403||e.status===401)return new V_(`the server does not know this page`);if(e.status===502||e.status===503||e.status===504)return new B_(`status ${e.status}`);let t;try{t=await e.json()}catch{return new U_(`the server answered ${e.status}`,e.status)}return e.status===409&&J_(t)?new H_(t):new U_(Y_(t)??`the server answered ${e.status}`,e.status,q_(t,`kind`),q_(t,`url`))}function q_(e,t){let n=(typeof e==`object`&&e&&`error`in e?e.error:null)?.[t];return typeof n==`string`?n:``}function J_(e){return typeof e==`object`&&!!e&&`version`in e&&`text`in e}function Y_(e){if(typeof e==`string`)return e;if(Array.isArray(e))return e.map(Y_).filter(e=>e!==null).join(`; `)||null;if(typeof e!=`object`||!e)return null;let t=e;if(typeof t.got==`string`&&typeof t.expected==`string`){let e=typeof t.where==`string`&&t.where?`${t.where}: `:``,n=typeof t.mend==`string`&&t.mend?`; ${t.mend}`:``;return`${e}got ${t.got}, expected ${t.expected}${n}`}return Y_(t.error??t.message??t.msg??t.detail??t.faults??null)}function Q(e,t={},...n){let r=document.createElement(e);return Q_(r,t),$_(r,n),r}var X_=`http://www.w3.org/2000/svg`;function Z_(e,t={},...n){let r=document.createElementNS(X_,e);return Q_(r,t),$_(r,n),r}function Q_(e,t){for(let[n,r]of Object.entries(t))r!=null&&r!==!1&&(typeof r==`function`?e.addEventListener(n.slice(2),r):e.setAttribute(n,r===!0?``:String(r)))}function $_(e,t){for(let n of t)n!=null&&n!==!1&&e.append(n)}var ev={copy:`M5.5 5.5h8v8h-8zM10.5 5.5v-3h-8v8h3`,remove:`M4 4l8 8M12 4l-8 8`,add:`M8 3v10M3 8h10`,undo:`M6 3L2.5 6.5 6 10M3 6.5h6.5a3.5 3.5 0 0 1 0 7H6`,redo:`M10 3l3.5 3.5L10 10M13 6.5H6.5a3.5 3.5 0 0 0 0 7H10`,theme:`M8 1.5v1.5M8 13v1.5M1.5 8H3M13 8h1.5M3.4 3.4l1 1M11.6 11.6l1 1M12.6 3.4l-1 1M4.4 11.6l-1 1M8 5a3 3 0 1 0 .01 0`};function tv(e){return Z_(`svg`,{viewBox:`0 0 16 16`,width:16,height:16,class:`icon-line`,"aria-hidden":`true`},Z_(`path`,{d:ev[e]}))}function $(e,...t){e.replaceChildren(),$_(e,t)}function nv(e,t){e.textContent!==t&&(e.textContent=t)}var rv=0;function iv(e){return rv+=1,`${e}-${rv}`}function av(e,t){let n=null,r=()=>{n!==null&&clearTimeout(n),n=null};return Object.assign(()=>{r(),n=setTimeout(()=>{n=null,t()},e)},{flush:()=>{n!==null&&(r(),t())},cancel:r})}function ov(e,t,n,r){return new Promise(i=>{let a=iv(`dialog`),o=Q(`dialog`,{class:`ask`,"aria-labelledby":a}),s=e=>{o.close(),o.remove(),i(e)};o.addEventListener(`cancel`,e=>{e.preventDefault(),r!==null&&s(r)});let c=n.map(e=>Q(`button`,{type:`button`,class:e.main?`main`:``,autofocus:e.main===!0,onclick:()=>s(e.value)},e.label));o.append(Q(`h2`,{id:a},e),...t.map(e=>typeof e==`string`?Q(`p`,{},e):e),Q(`div`,{class:`answers`},...c)),document.body.append(o),o.showModal()})}function sv(e,t,n){return new Promise(r=>new cv(e,t,n,r).start())}var cv=class{api;purpose;present;resolve;place=Q(`input`,{type:`text`,class:`path`,"aria-label":`folder`,spellcheck:`false`});list=Q(`div`,{class:`files`,role:`listbox`,"aria-label":`folders and case files`,tabindex:0});name=Q(`input`,{type:`text`,id:iv(`name`),spellcheck:`false`,placeholder:`slab.toml`});message=Q(`p`,{class:`messages`,role:`alert`});dialog;folder=null;turn=0;constructor(e,t,n,r){this.api=e,this.purpose=t,this.present=n,this.resolve=r;let i=t===`open`?`Open`:`Save`,a=t===`open`?`Open a case file`:`Save the case file as`,o=Q(`button`,{type:`button`,class:`small`,title:`Folder above`,onclick:()=>this.folder?.parent&&void this.show(this.folder.parent)},`↑ Up`),s=Q(`form`,{method:`dialog`,class:`file-form`},Q(`h2`,{},a),Q(`div`,{class:`file-place`},o,this.place),this.list,Q(`div`,{class:`file-name`},Q(`label`,{for:this.name.id},`Name`),this.name),this.message,Q(`div`,{class:`answers`},Q(`button`,{type:`button`,onclick:()=>this.close(null)},`Cancel`),Q(`button`,{type:`submit`,class:`main`},i)));this.dialog=Q(`dialog`,{class:`file-dialog`,"aria-label":a},s),s.addEventListener(`submit`,e=>{e.preventDefault(),this.accept()}),this.dialog.addEventListener(`cancel`,e=>{e.preventDefault(),this.close(null)}),this.place.addEventListener(`input`,()=>this.turn+=1),this.place.addEventListener(`keydown`,e=>{e.key===`Enter`&&(e.preventDefault(),this.show(this.place.value))}),this.list.addEventListener(`keydown`,e=>this.walk(e))}start(){document.body.append(this.dialog),this.dialog.showModal();let{present:e}=this;this.name.value=e===null?``:e.split(/[\\/]/).at(-1)??``;let t=e===null?null:e.slice(0,Math.max(e.lastIndexOf(`/`),e.lastIndexOf(`\\`)));this.name.focus(),this.show(t||null)}close(e){this.dialog.close(),this.dialog.remove(),this.resolve(e)}async show(e){let t=this.turn+=1;try{let n=await this.api.files(e);if(t!==this.turn)return;this.folder=n}catch(e){this.message.textContent=e instanceof U_?e.message:`The server does not answer.`;return}this.message.textContent=``,this.place.value=this.folder.folder;let{folders:n,files:r}=this.folder;$(this.list,...n.map(e=>this.entry(e,!0)),...r.map(e=>this.entry(e,!1)),n.length+r.length===0?Q(`p`,{class:`empty`},`No case files (*.toml) in this folder.`):null)}entry(e,t){let n=()=>t?void this.show(this.path(e)):void this.accept(),r=Q(`button`,{type:`button`,class:t?`entry folder`:`entry`,role:`option`,tabindex:-1,ondblclick:n},t?`${e}/`:e);return r.addEventListener(`click`,()=>{if(t)return n();this.name.value=e;for(let e of this.list.children)e.setAttribute(`aria-selected`,String(e===r))}),r}walk(e){if(e.key!==`ArrowDown`&&e.key!==`ArrowUp`)return;e.preventDefault();let t=[...this.list.querySelectorAll(`button`)],n=t.findIndex(e=>e===document.activeElement);t[Math.min(t.length-1,Math.max(0,n+(e.key===`ArrowDown`?1:-1)))]?.focus()}path(e){let t=this.folder?.folder??``,n=t.includes(`\\`)?`\\`:`/`;return t.endsWith(n)?t+e:t+n+e}async accept(){let e=this.name.value.trim();if(!e){this.message.textContent=`Choose a file, or write a name.`;return}this.purpose===`save`&&!/\.[A-Za-z0-9]+$/.test(e)&&(e+=`.toml`);let t=/^([A-Za-z]:)?[\\/]/.test(e)?e:this.path(e),n=this.folder?.files.includes(e)===!0;if(this.purpose===`save`&&n&&t!==this.present)return await ov(`Replace the file?`,[`${e} is there already.`],[{label:`Keep it`,value:!1,main:!0},{label:`Replace it`,value:!0}],!1)?this.close({file:t,over:!0}):void 0;this.close({file:t,over:!1})}},lv=class{api;store;queue;lost;flush;showFaults;offered;constructor(e,t,n,r,i,a,o){this.api=e,this.store=t,this.queue=n,this.lost=r,this.flush=i,this.showFaults=a,this.offered=o}undo=()=>this.change(()=>this.api.undo());redo=()=>this.change(()=>this.api.redo());save=async()=>(this.store.doc?.file??null)===null?this.saveAs():this.saveTo(null,!1);saveAs=async()=>{let e=await sv(this.api,`save`,this.store.doc?.file??null);return e?this.saveTo(e.file,e.over):!1};async saveTo(e,t){let n=e=>!t&&(e.kind===`changed`||e.kind===`exists`),r=``,i=await this.change(()=>this.api.save(e,t),`saved`,e=>(n(e)&&(r=e.kind),r!==``));if(i||r===``)return i;let a=await ov(`Replace the file?`,[r===`exists`?`There is a file of this name already.`:`Another program has changed the file since it was read here. Saving replaces what it has written.`],[{label:`Do not save`,value:`no`,main:!0},{label:`Save as …`,value:`as`},{label:`Replace it`,value:`over`}],`no`);return a===`over`?this.saveTo(e,!0):a===`as`&&this.saveAs()}open=async()=>{let e=await sv(this.api,`open`,this.store.doc?.file??null);e&&await this.openFile(e.file)};openFile=async e=>{await this.mayLeave()&&await this.change(()=>this.api.open(e))&&this.another()};fresh=async()=>{await this.mayLeave()&&await this.change(()=>this.api.fresh())&&this.another()};solve=async()=>{if((this.store.doc?.faults.length??0)>0)return this.showFaults();await this.asking(async()=>void await this.api.solve())};cancel=()=>this.asking(()=>this.api.cancel());autosolve=e=>this.asking(async()=>{await this.api.autosolve(e),this.store.autosolve=e,this.store.tell(`autosolve`)});another(){this.store.setSolved(null),this.store.setRun({kind:`idle`}),this.store.select(null)}async mayLeave(){if(this.flush(),await this.queue.run(),this.store.doc?.dirty!==!0)return!0;let e=await ov(`Save the changes first?`,[`The present case has changes that are not saved. If you leave it so, they stay kept, and are offered when it is opened again.`],[{label:`Stay`,value:`stay`},{label:`Leave`,value:`leave`},{label:`Save`,value:`save`,main:!0}],`stay`);return e===`leave`||e===`save`&&await this.save()}async change(e,t,n=()=>!1){return this.asking(async()=>{let n=await e();this.store.setDoc(n.offer?await this.offered(n):n),t&&this.store.say({kind:`info`,text:`${this.store.doc?.file??`The case`} is ${t}.`})},n)}async asking(e,t=()=>!1){this.flush(),await this.queue.run();try{return await e(),!0}catch(e){if(e instanceof B_||e instanceof V_)this.lost(e);else if(e instanceof U_&&t(e))return!1;else this.store.say({kind:`bad`,text:e instanceof U_?e.message:String(e),...e instanceof U_?uv(e):{}});return!1}}};function uv(e){let{url:t}=e;return/^http:\/\/(127\.0\.0\.1|localhost):\d+\//.test(t)?{action:{label:`Go there`,run:()=>void window.open(t,`_blank`,`noopener`)}}:{}}function dv(e,t){let n=Q(`div`,{class:`banner`,role:`alert`,hidden:!0});return e.on([`connection`,`waiting`],()=>{let r=e.waitingCount,i=r===0?`Nothing is lost.`:r===1?`1 edit is kept here and sent when it answers.`:`${r} edits are kept here and sent when it answers.`;n.hidden=e.connection===`ok`,e.connection===`away`?$(n,Q(`strong`,{},`The server does not answer. `),`${i} If it has ended, start it again with `,Q(`code`,{},fv(e)),`. `,Q(`button`,{type:`button`,class:`small`,onclick:t},`Try now`)):e.connection===`stranger`&&$(n,Q(`strong`,{},`Another server has been started. `),`${i} Open the address that it has printed; this page then goes on with it. `,Q(`button`,{type:`button`,class:`small`,onclick:t},`Try now`))}),n}function fv(e){let t=e.doc?.file;return`groundslab app --port ${location.port}${t?` "${t}"`:``}`}var pv=6e3;function mv(e){let t=Q(`div`,{class:`notice`,role:`status`,hidden:!0}),n=null;return e.on([`notice`],()=>{n!==null&&clearTimeout(n);let{notice:r}=e;if(t.hidden=r===null,!r)return;t.className=`notice ${r.kind}`;let{action:i}=r;$(t,Q(`span`,{},r.text),i?Q(`button`,{type:`button`,class:`small`,onclick:()=>{e.say(null),i.run()}},i.label):null,Q(`button`,{type:`button`,class:`icon`,"aria-label":`close this message`,onclick:()=>e.say(null)},`×`)),n=r.kind===`info`?setTimeout(()=>e.say(null),pv):null}),t}var hv=400,gv=4e3,_v=100,vv=class{api;store;queue;hooks;events;source=null;wait=hv;retrying=!1;another=!1;timer=null;checking=null;constructor(e,t,n,r,i=e=>new EventSource(e)){this.api=e,this.store=t,this.queue=n,this.hooks=r,this.events=i,t.on([`doc`],()=>this.askAgain())}askAgain(){this.store.doc?.checking&&this.checking===null&&(this.checking=setTimeout(()=>{this.checking=null,this.refreshFrom(-1)},_v))}async start(){try{this.store.schema??=await this.api.schema();let e=await this.api.state();await this.welcome(e),this.listen(),this.store.setConnection(`ok`),this.wait=hv}catch(e){if(!(e instanceof B_||e instanceof V_))throw e;this.lost(e)}}lost(e){this.queue.hold(),this.close(),this.store.setConnection(e instanceof V_?`stranger`:`away`),this.again()}retry(e=!1){this.another||=e,this.wait=hv,this.timer!==null&&clearTimeout(this.timer),this.timer=null,this.attempt()}again(){this.timer!==null||this.retrying||(this.timer=setTimeout(()=>{this.timer=null,this.attempt()},this.wait),this.wait=Math.min(gv,this.wait*1.6))}async attempt(){this.retrying||(this.retrying=!0,await this.start().finally(()=>{this.retrying=!1}),this.store.connection!==`ok`&&this.again())}async welcome(e){let t=this.store.doc,n=yv(t,e,this.another,this.queue.waiting.length>0),r=e;e.offer?(this.queue.hold(),r=await this.hooks.offered(e)):n===`differs`&&t&&(this.queue.hold(),await this.hooks.differs(e,t.text)===`page`?r=await this.api.edit({edits:[{op:`text`,value:t.text}],text:`keep the page's text`},e.version):this.queue.clear()),this.another&&this.store.setSolved(null),this.another=!1,t&&t.text!==r.text&&this.queue.rebase(r),this.store.setDoc(r),await this.queue.release()}listen(){this.close();let e=this.events(this.api.eventsAddress());this.source=e;let t=(t,n)=>e.addEventListener(t,e=>n(JSON.parse(e.data)));t(`state`,e=>void this.refreshFrom(Number(e.version))),t(`saved`,()=>void this.refreshFrom(-1)),t(`solving`,e=>this.store.setRun({kind:`solving`,run:Number(e.run),version:Number(e.version),text:``,share:null})),t(`progress`,e=>this.progress(e)),t(`solved`,e=>{this.store.setRun({kind:`idle`}),this.store.setSolved({run:Number(e.run),version:Number(e.version),seconds:Number(e.seconds),design:String(e.design??``)})}),t(`refused`,e=>{let t=Array.isArray(e.faults)?e.faults:[];this.store.setRun({kind:`refused`,version:Number(e.version),message:String(e.message??``),faults:t})}),t(`cancelled`,()=>this.store.setRun({kind:`cancelled`})),e.addEventListener(`error`,()=>{this.source===e&&(this.close(),this.retry())})}progress(e){let{run:t}=this.store;if(t.kind!==`solving`||t.run!==Number(e.run))return;let n=typeof e.share==`number`?e.share:null;this.store.setRun({...t,text:String(e.text??``),share:n})}async refreshFrom(e){if(!(this.queue.waiting.length>0||e===this.store.doc?.version))try{let e=await this.api.state();this.queue.waiting.length===0&&this.store.setDoc(e)}catch(e){(e instanceof B_||e instanceof V_)&&this.lost(e)}}close(){this.source?.close(),this.source=null}};function yv(e,t,n,r){return t.offer?`offer`:e?e.text===t.text?`same`:n&&(r||e.dirty)?`differs`:`adopt`:`adopt`}var bv=class{api;hooks;waiting=[];busy=null;held=!1;repeated=!1;constructor(e,t){this.api=e,this.hooks=t}push(e){let t=this.waiting.at(-1),n=this.busy!==null&&this.waiting.length===1;t&&!n&&Sv(t,e)?this.waiting[this.waiting.length-1]=t.merge?e:xv(e):this.waiting.push(e),this.hooks.changed(),this.run()}run(){return this.held?Promise.resolve():(this.busy??=this.send().finally(()=>{this.busy=null}),this.busy)}hold(){this.held=!0}release(){return this.held=!1,this.run()}rebase(e){let t=this.waiting.filter(t=>!this.hooks.fits(t,e));if(t.length===0)return;let n=this.waiting.filter(e=>!t.includes(e));this.waiting.splice(0,this.waiting.length,...n),this.hooks.changed();for(let e of t)this.hooks.refused(e,`this part was changed elsewhere meanwhile`)}clear(){this.waiting.length=0,this.hooks.changed()}async send(){for(let e=this.waiting[0];e&&!this.held;e=this.waiting[0])try{let t=await this.api.edit(e,this.hooks.base());this.done(e),this.hooks.adopt(t,this.waiting)}catch(t){if(t instanceof B_||t instanceof V_){this.held=!0,this.repeated=!0,this.hooks.lost(t);return}this.afterNo(e,t)}}afterNo(e,t){if(t instanceof H_){let n=this.repeated&&t.state.undo_text===e.text&&t.state.version===this.hooks.base()+1,r=n||this.hooks.fits(e,t.state);(n||!r)&&this.done(e),this.hooks.adopt(t.state,this.waiting),r||this.hooks.refused(e,`this part was changed elsewhere meanwhile`),this.repeated=!1}else this.done(e),this.hooks.changed(),this.hooks.refused(e,t instanceof U_?t.message:String(t))}done(e){this.waiting[0]===e&&this.waiting.shift(),this.repeated=!1}};function xv(e){return{edits:e.edits,text:e.text}}function Sv(e,t){if(!t.merge||e.text!==t.text)return!1;let n=e=>JSON.stringify(e.edits.map(e=>[e.op===`remove`?`set`:e.op,`path`in e?e.path:null]));return t.edits.every(e=>e.op===`set`||e.op===`remove`||e.op===`length`||e.op===`text`)&&n(e)===n(t)}function Cv(e){return typeof e==`object`&&!!e&&!Array.isArray(e)}function wv(e,t){let n=e;for(let e of t)if(n=typeof e==`number`?Array.isArray(n)?n[e]:void 0:Cv(n)&&Object.hasOwn(n,e)?n[e]:void 0,n===void 0)return;return n}function Tv(e,t){let n=wv(e,t);return Cv(n)?n:{}}function Ev(e,t){let n=wv(e,t);return Array.isArray(n)?n:[]}function Dv(e){return JSON.stringify(e)}function Ov(e){let t=``;for(let n of e)t+=typeof n==`number`?`[${n+1}]`:t?`.${n}`:n;return t}function kv(e,t){return e===null||t===null?e===t:e.length===t.length&&e.every((e,n)=>e===t[n])}function Av(e,t){return e.length>=t.length&&t.every((t,n)=>t===e[n])}function jv(e,t){if(e===t)return!0;if(Array.isArray(e)&&Array.isArray(t))return e.length===t.length&&e.every((e,n)=>jv(e,t[n]));if(!Cv(e)||!Cv(t))return!1;let n=Object.keys(e);return n.length===Object.keys(t).length&&n.every(n=>Object.hasOwn(t,n)&&jv(e[n],t[n]))}var Mv={m:1,mm:.001,cm:.01,dm:.1,km:1e3,ft:.3048,foot:.3048,feet:.3048,in:.0254,inch:.0254,yd:.9144,yard:.9144},Nv=/^\s*([+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?)\s*([A-Za-z]+)\s*$/;function Pv(e){let t=typeof e==`string`?Nv.exec(e):null,n=t?Mv[t[2]??``]:void 0;return!t||n===void 0?null:n<1&&n.toString().startsWith(`0.0`)&&Math.log10(n)%1==0&&Number(`${Number(t[1])}e${Math.round(Math.log10(n))}`)||Number(t[1])*n}function Fv(e){if(!Array.isArray(e)||e.length!==2)return null;let[t,n]=[Pv(e[0]),Pv(e[1])];return t===null||n===null?null:[t,n]}function Iv(e){if(!Array.isArray(e))return null;let t=e.map(Fv);return t.every(e=>e!==null)?t:null}function Lv(e){let t=typeof e==`string`?Nv.exec(e)?.[2]:void 0;return t!==void 0&&t in Mv?t:`m`}function Rv(e,t){let n=e.toFixed(t),r=n.includes(`.`)?n.replace(/0+$/,``).replace(/\.$/,``):n;return r===`-0`?`0`:r}function zv(e,t=`m`){let n=Mv[t]??1,r=Math.max(0,Math.round(4+Math.log10(n)));return`${Rv(e/n,r)} ${t}`}function Bv(e,t){if(typeof t==`number`)return zv(t,Lv(e));let n=Array.isArray(e)?e:[];return t.map((e,t)=>Bv(n[t]??n.at(-1),e))}function Vv(e,t){if(!Cv(e))return e;let n={...e};for(let[r,i]of Object.entries(e))r===`x`||r===`y`?n[r]=Hv(i,t[r===`x`?0:1]):r===`centre`||r===`start`||r===`end`||r===`about`?n[r]=Uv(i,t):r===`points`&&Array.isArray(i)?n[r]=i.map(e=>Uv(e,t)):r===`shape`&&(n[r]=Vv(i,t));return n}function Hv(e,t){if(Array.isArray(e))return e.map(e=>Hv(e,t));let n=Pv(e);return n===null?e:Bv(e,n+t)}function Uv(e,t){return Array.isArray(e)?e.map((e,n)=>Hv(e,t[n]??0)):e}function Wv(e,t){switch(t.op){case`text`:return e;case`set`:return Gv(e,t.path,()=>t.value);case`length`:return Gv(e,t.path,e=>Bv(e,t.value));case`move`:return Gv(e,t.path,e=>e===void 0?void 0:Vv(e,t.by));case`remove`:return Gv(e,t.path,()=>void 0);case`add`:{let n=wv(e,t.path),r=Array.isArray(n)?[...n]:[];return r.splice(t.at??r.length,0,t.value),Gv(e,t.path,()=>r)}}}function Gv(e,t,n){let r=Kv(e,t,n);return Cv(r)?r:e}function Kv(e,t,n){let[r,...i]=t;if(r===void 0)return n(e);if(typeof r==`number`){if(!Array.isArray(e)||r>=e.length)return e;let t=Kv(e[r],i,n);return t===void 0?e.filter((e,t)=>t!==r):e.map((e,n)=>n===r?t:e)}if(e!==void 0&&!Cv(e))return e;let a={...e},o=Kv(a[r],i,n);if(o===void 0){if(e===void 0)return;delete a[r]}else a[r]=o;return a}var qv=class{doc=null;schema=null;connection=`ok`;run={kind:`idle`};solved=null;autosolve=!1;selection=null;notice=null;data={};readable={};waiting=[];listeners=new Map;on(e,t){for(let n of e){let e=this.listeners.get(n)??new Set;this.listeners.set(n,e.add(t))}return()=>{for(let n of e)this.listeners.get(n)?.delete(t)}}tell(e){for(let t of[...this.listeners.get(e)??[]])t()}setDoc(e,t=this.waiting){let n=t.length!==this.waiting.length;this.doc=e,this.waiting=[...t],this.readable=e.data??this.readable,e.autosolve!==void 0&&e.autosolve!==this.autosolve&&(this.autosolve=e.autosolve,this.tell(`autosolve`)),this.foreseeAll(),n&&this.tell(`waiting`),this.tell(`doc`),this.tell(`data`)}setWaiting(e){this.waiting=[...e],this.foreseeAll(),this.tell(`waiting`),this.tell(`data`)}get waitingCount(){return this.waiting.length}get waitingText(){let e=this.waiting.flatMap(e=>e.edits).findLast(e=>e.op===`text`);return e?.op===`text`?e.value:null}setConnection(e){this.connection!==e&&(this.connection=e,this.tell(`connection`))}setRun(e){this.run=e,this.tell(`run`)}setSolved(e){this.solved=e,this.tell(`solved`)}select(e){kv(this.selection,e)||(this.selection=e,this.tell(`selection`))}say(e){this.notice=e,this.tell(`notice`)}get broken(){return this.doc!==null&&this.doc.data===null&&!this.doc.checking}foreseeAll(){let e=this.readable;for(let t of this.waiting)for(let n of t.edits)e=Wv(e,n);this.data=e}};function Jv(e){return e.flatMap(e=>{let t=typeof e==`object`&&e&&!Array.isArray(e)?e.name:void 0;return typeof t==`string`&&t?[t]:[]})}function Yv(e,t){let n=wv(e,t);if(!Cv(n))return null;if(n.start!==void 0&&n.end!==void 0){let[e,r]=[Fv(n.start),Fv(n.end)];return e&&r?{type:`segment`,at:t,start:e,end:r}:null}if(n.radius!==void 0){let[e,r]=[n.centre===void 0?[0,0]:Fv(n.centre),Pv(n.radius)];return e&&r!==null&&r>0?{type:`circle`,at:t,centre:e,radius:r}:null}if(Array.isArray(n.x)){let[e,r]=[Fv(n.x),Fv(n.y)];return e&&r?{type:`box`,at:t,x:e,y:r}:null}if(n.points!==void 0){let e=Iv(n.points);if(!e||e.length===0)return null;let r=Array.isArray(n.bulges)?n.bulges.map(e=>typeof e==`number`?e:0):[];return n.kind===`polygon`?{type:`polygon`,at:t,points:e,bulges:r}:r.some(e=>e!==0)?{type:`line`,at:t,points:e,bulges:r}:{type:`line`,at:t,points:e}}let[r,i]=[Pv(n.x),Pv(n.y)];return r!==null&&i!==null?{type:`point`,at:t,x:r,y:i}:null}function Xv(e){let[t,n]=[Pv(wv(e,[`plate`,`length_x`])),Pv(wv(e,[`plate`,`length_y`]))];return t!==null&&n!==null&&t>0&&n>0?{type:`sides`,at:[`plate`],x:t,y:n}:null}var Zv=2*Math.PI/180;function Qv(e){switch(e.type){case`sides`:return $v([-e.x/2,e.x/2],[-e.y/2,e.y/2]);case`box`:return $v(e.x,e.y);case`polygon`:return e.points.flatMap((t,n)=>[t,...ey(t,e.points[(n+1)%e.points.length]??t,e.bulges[n]??0)]);case`circle`:return Array.from({length:180},(t,n)=>{let r=n*Zv;return[e.centre[0]+e.radius*Math.cos(r),e.centre[1]+e.radius*Math.sin(r)]});case`line`:return e.points.flatMap((t,n)=>{let r=e.points[n+1];return r?[t,...ey(t,r,e.bulges?.[n]??0)]:[t]});case`point`:return[[e.x,e.y]];case`segment`:return[e.start,e.end];default:return e.points}}function $v(e,t){return[[e[0],t[0]],[e[1],t[0]],[e[1],t[1]],[e[0],t[1]]]}function ey(e,t,n){if(n===0)return[];let r=[t[0]-e[0],t[1]-e[1]],i=Math.hypot(...r);if(i===0)return[];let a=4*Math.atan(n),o=i/2/Math.tan(a/2),s=[(e[0]+t[0])/2-r[1]/i*o,(e[1]+t[1])/2+r[0]/i*o],c=Math.atan2(e[1]-s[1],e[0]-s[0]),l=Math.hypot(e[0]-s[0],e[1]-s[1]),u=Math.max(2,Math.ceil(Math.abs(a)/Zv));return Array.from({length:u-1},(e,t)=>{let n=c+a*(t+1)/u;return[s[0]+l*Math.cos(n),s[1]+l*Math.sin(n)]})}function ty(e){return e.type===`fixed`?e.closed:![`point`,`line`,`segment`].includes(e.type)}function ny(e){let t=0;return e.forEach(([n,r],i)=>{let[a,o]=e[(i+1)%e.length]??[n,r];t+=n*o-a*r}),t/2}function ry(e,[t,n]){let r=!1;return e.forEach(([i,a],o)=>{let[s,c]=e[(o+1)%e.length]??[i,a];a>n!=c>n&&t<i+(n-a)/(c-a)*(s-i)&&(r=!r)}),r}function iy(e,t,[n,r]){let[i,a]=[t[0]-e[0],t[1]-e[1]],o=i*i+a*a,s=o===0?0:Math.min(1,Math.max(0,((n-e[0])*i+(r-e[1])*a)/o)),c=[e[0]+s*i,e[1]+s*a];return{at:c,distance:Math.hypot(c[0]-n,c[1]-r)}}function ay(e){let t=null;for(let[n,r]of e)t=t?[Math.min(t[0],n),Math.min(t[1],r),Math.max(t[2],n),Math.max(t[3],r)]:[n,r,n,r];return t}function oy(e,[t,n]){let r=([e,r])=>[e+t,r+n];switch(e.type){case`sides`:return e;case`box`:return{...e,x:[e.x[0]+t,e.x[1]+t],y:[e.y[0]+n,e.y[1]+n]};case`circle`:return{...e,centre:r(e.centre)};case`point`:return{...e,x:e.x+t,y:e.y+n};case`segment`:return{...e,start:r(e.start),end:r(e.end)};default:return{...e,points:e.points.map(r)}}}function sy(e,t){let n=[],r=(t,r,i)=>{JSON.stringify(r)!==JSON.stringify(i)&&n.push({op:`length`,path:[...e.at,t],value:i})};return e.type===`sides`&&t.type===`sides`?(r(`length_x`,e.x,t.x),r(`length_y`,e.y,t.y)):e.type===`box`&&t.type===`box`||e.type===`point`&&t.type===`point`?(r(`x`,e.x,t.x),r(`y`,e.y,t.y)):e.type===`circle`&&t.type===`circle`?(r(`centre`,e.centre,t.centre),r(`radius`,e.radius,t.radius)):e.type===`segment`&&t.type===`segment`?(r(`start`,e.start,t.start),r(`end`,e.end,t.end)):e.type===`line`&&t.type===`line`?(r(`points`,e.points,t.points),JSON.stringify(e.bulges)!==JSON.stringify(t.bulges)&&n.push({op:`set`,path:[...e.at,`bulges`],value:[...t.bulges??[]]})):e.type===`polygon`&&t.type===`polygon`&&(r(`points`,e.points,t.points),JSON.stringify(e.bulges)!==JSON.stringify(t.bulges)&&n.push({op:`set`,path:[...e.at,`bulges`],value:[...t.bulges]})),n}var cy=[{kind:`soil zone`,list:[`soil_zones`],word:`soil zone`,below:`shape`},{kind:`zone`,list:[`plate`,`zones`],word:`zone`,below:`shape`},{kind:`opening`,list:[`plate`,`openings`],word:`opening`},{kind:`void`,list:[`contact`,`voids`],word:`void`},{kind:`gap`,list:[`contact`,`gaps`],word:`measured gap`},{kind:`support`,list:[`supports`],word:`support`},{kind:`column`,list:[`columns`],word:`column`},{kind:`load`,list:[`loads`],word:`load`},{kind:`borehole`,list:[`boreholes`],word:`borehole`},{kind:`strip`,list:[`output`,`strips`],word:`strip`},{kind:`section line`,list:[`output`,`lines`],word:`section line`},{kind:`output point`,list:[`output`,`points`],word:`output point`}],ly=new Set([`uniform`,`self weight`,`temperature`,`settlement`]);function uy(e,t){return[...dy(e,t),...cy.flatMap(n=>fy(n,e,t))]}function dy(e,t){let n=Tv(e,[`plate`]),r=n.outline!==void 0,i=r?[`plate`,`outline`]:[`plate`],a=(r?Yv(e,i):Xv(e))??vy(t?.outline,i);return a?[{kind:`slab`,path:i,title:`slab`,table:n,geometry:a,foot:null,movable:r}]:[]}function fy(e,t,n){return Ev(t,e.list).flatMap((r,i)=>{if(!Cv(r))return[];let a=[...e.list,i],o=py(e.word,r,i),s=e.kind===`load`?hy(t,r):null;if(s){let t={type:`point`,at:a,x:s.x,y:s.y};return[{kind:e.kind,path:a,title:o,table:r,geometry:t,foot:null,movable:!1}]}if(e.kind===`load`&&ly.has(String(r.kind)))return[];let c=Yv(t,e.below?[...a,e.below]:a)??(r.shape===void 0?null:Yv(t,[...a,`shape`]))??_y(n,a);return c?[{kind:e.kind,path:a,title:o,table:r,geometry:c,foot:gy(r,c),movable:!0}]:[]})}function py(e,t,n){let r=e===`load`||e===`support`?`${typeof t.kind==`string`?t.kind:``} ${e}`.trim():e;return typeof t.name==`string`&&t.name?`${r} ${t.name}`:`${r} ${n+1}`}function my(e,t){let n=cy.find(e=>e.list.length+1===t.length&&e.list.every((e,n)=>e===t[n])),r=t.at(-1);return n&&typeof r==`number`?py(n.word,Tv(e,t),r):t[0]===`plate`&&t.length<3?`slab`:Ov(t)}function hy(e,t){if(typeof t.column!=`string`||!t.column)return null;let n=Ev(e,[`columns`]).find(e=>Cv(e)&&e.name===t.column),[r,i]=[Pv(wv(n,[`x`])),Pv(wv(n,[`y`]))];return r!==null&&i!==null?{x:r,y:i}:null}function gy(e,t){if(t.type!==`point`)return null;let{x:n,y:r}=t,i=Pv(e.diameter);if(i!==null&&i>0)return Qv({type:`circle`,at:[],centre:[n,r],radius:i/2});let[a,o]=[Pv(e.width_x),Pv(e.width_y)];return a===null||o===null||a<=0||o<=0?null:$v([n-a/2,n+a/2],[r-o/2,r+o/2])}function _y(e,t){if(!e)return null;let n=Ov(t);for(let r of Object.values(e)){let e=Array.isArray(r)?r.find(e=>Cv(e)&&e.path===n):void 0;if(!Cv(e))continue;if(typeof e.x==`number`&&typeof e.y==`number`)return{type:`point`,at:t,x:e.x,y:e.y};let i=e.points??(e.start&&e.end?[e.start,e.end]:void 0);return vy(e.ring??i,t,e.ring!==void 0)}return null}function vy(e,t,n=!0){if(!Array.isArray(e))return null;let r=e.flatMap(e=>Array.isArray(e)&&typeof e[0]==`number`&&typeof e[1]==`number`?[[e[0],e[1]]]:[]);return r.length>0?{type:`fixed`,at:t,points:r,closed:n}:null}function yy(e){return ay(e.flatMap(e=>[...Qv(e.geometry)]))}function by(e,t){let n=[[0,0]];for(let{geometry:r,path:i}of e)t&&Ov(i)===Ov(t)||(r.type===`circle`?n.push(r.centre):n.push(...Qv(r.type===`polygon`?{...r,bulges:[]}:r)));return n}var xy=[{names:`columns`,list:`loads`,key:`column`},{names:`supports`,list:`loads`,key:`support`},{names:`cases`,list:`loads`,key:`case`}];function Sy(e,t){let[n,,r]=t,i=xy.find(e=>e.list===n&&e.key===r);return!i||t.length!==3?null:Jv(Ev(e,[i.names]))}function Cy(e){return e.length===3&&e[2]===`name`&&xy.some(t=>t.names===e[0])}function wy(e,t,n){if(!Cy(t)||!n)return[];let r=Ev(e,[t[0]])[t[1]],i=Cv(r)?r.name:void 0,a=Jv(Ev(e,[t[0]]));if(typeof i!=`string`||!i||i===n||a.filter(e=>e===i).length>1||a.includes(n))return[];let o=[];for(let r of xy.filter(e=>e.names===t[0]))Ty(e,r,i).forEach(e=>o.push({op:`set`,path:[r.list,e,r.key],value:n}));return t[0]===`cases`&&Ev(e,[`combinations`]).forEach((e,t)=>{let r=Cv(e)&&Cv(e.factors)?e.factors:{};if(!(i in r))return;let a=Object.fromEntries(Object.entries(r).map(([e,t])=>[e===i?n:e,t]));o.push({op:`set`,path:[`combinations`,t,`factors`],value:a})}),o}function Ty(e,t,n){return Ev(e,[t.list]).flatMap((e,r)=>Cv(e)&&e[t.key]===n?[r]:[])}function Ey(e,t){let n=my(e,t),r=t[0],i=typeof t[1]==`number`&&t.length===2?Ev(e,[r])[t[1]]:void 0,a=Cv(i)&&typeof i.name==`string`?i.name:``,o=Jv(Ev(e,[String(r)])).filter(e=>e===a).length===1,s=a&&o&&(r===`columns`||r===`supports`)?xy.filter(e=>e.names===r).flatMap(t=>Ty(e,t,a)):[],c=[...s].sort((e,t)=>t-e).map(e=>({op:`remove`,path:[`loads`,e]}));return c.push({op:`remove`,path:t}),{edits:c,text:`remove ${n}${s.length===0?``:s.length===1?` and its load`:` and its ${s.length} loads`}`}}var Dy={E:`20 MPa`,nu:.3,thickness:`4 m`},Oy={Plate:{length_x:`6 m`,length_y:`4 m`,thickness:`300 mm`,E:`30 GPa`,nu:.2},Winkler:{kind:`winkler`,k:`20 MPa/m`},Pasternak:{kind:`pasternak`,k0:`20 MPa/m`,k1:`10 MN/m`},Vlasov:{kind:`vlasov`,layers:[Dy]},Layered:{kind:`layered`,coupling:`consistent`,layers:[Dy]},Selvadurai:{E:`20 MPa`,depth:`5 m`},SoilLayer:Dy,InterfaceLayer:{k0:`20 MPa/m`,k1:`10 MN/m`},UniformLoad:{kind:`uniform`,q:`5 kPa`},PatchLoad:{kind:`patch`,q:`20 kPa`},AreaLoad:{kind:`area`,q:`20 kPa`},LineLoad:{kind:`line`,q:`20 kN/m`},PointLoad:{kind:`point`,P:`100 kN`},SelfWeight:{kind:`self weight`,unit_weight:`25 kN/m^3`},TemperatureLoad:{kind:`temperature`,difference:`10 K`},SettlementLoad:{kind:`settlement`,w:`5 mm`},PointSupport:{kind:`point`},LineSupport:{kind:`line`},LoadCase:{action:`permanent`},Combination:{limit_state:`ultimate`},Combine:{sets:[`ultimate`,`characteristic`]},Reinforcement:{f_ck:`30 MPa`,f_yk:`500 MPa`,bottom:[`40 mm`,`50 mm`],top:[`40 mm`,`50 mm`]},Void:{depth:`10 mm`}};function ky(e,t){return e===`Zone`?{thickness:Ay(t)}:e===`Borehole`?{layers:jy(t)}:structuredClone(Oy[e]??{})}function Ay(e){let t=Pv(wv(e,[`plate`,`thickness`]));return t===null?`600 mm`:zv(Math.round(t*1.5*20)/20,`mm`)}function jy(e){let t=Ev(e,[`ground`,`layers`]).filter(Cv);return structuredClone(t.length>0?t:[Dy])}var My=2e4,Ny=.2,Py=class{x=0;y=0;scale=50;width=1;height=1;toPixel([e,t]){return[this.width/2+(e-this.x)*this.scale,this.height/2-(t-this.y)*this.scale]}toPlan([e,t]){return[this.x+(e-this.width/2)/this.scale,this.y-(t-this.height/2)/this.scale]}pan(e,t){this.x-=e/this.scale,this.y+=t/this.scale}zoom(e,t=[this.width/2,this.height/2]){let n=this.toPlan(t);this.scale=Math.min(My,Math.max(Ny,this.scale*e));let r=this.toPlan(t);this.x+=n[0]-r[0],this.y+=n[1]-r[1]}fit([e,t,n,r],i=46){this.x=(e+n)/2,this.y=(t+r)/2;let[a,o]=[Math.max(n-e,.1),Math.max(r-t,.1)],s=Math.min((this.width-2*i)/a,(this.height-2*i)/o);this.scale=Math.min(My,Math.max(Ny,s))}};function Fy(e){switch(e.type){case`sides`:return Ry([-e.x/2,e.x/2],[-e.y/2,e.y/2]);case`box`:return Ry(e.x,e.y);case`polygon`:return[...Iy(e.points,`corner`),...Ly(e.points,!0,e.bulges)];case`line`:return[...Iy(e.points,`corner`),...Ly(e.points,!1,e.bulges??[])];case`circle`:return[[1,0],[0,1],[-1,0],[0,-1]].map(([t,n],r)=>({kind:`radius`,index:r,at:[e.centre[0]+t*e.radius,e.centre[1]+n*e.radius]}));case`segment`:return[e.start,e.end].map((e,t)=>({kind:`end`,index:t,at:e}));default:return[]}}function Iy(e,t){return e.map((e,n)=>({kind:t,index:n,at:e}))}function Ly(e,t,n){let r=t?e.length:e.length-1;return e.slice(0,r).flatMap((t,r)=>{let i=e[(r+1)%e.length];return!i||n[r]?[]:[{kind:`add`,index:r,at:[(t[0]+i[0])/2,(t[1]+i[1])/2]}]})}function Ry(e,t){let[n,r]=[(e[0]+e[1])/2,(t[0]+t[1])/2],i=[{kind:`edge`,index:0,at:[e[0],r],along:`x`},{kind:`edge`,index:1,at:[e[1],r],along:`x`},{kind:`edge`,index:2,at:[n,t[0]],along:`y`},{kind:`edge`,index:3,at:[n,t[1]],along:`y`}];return[...$v(e,t).map((e,t)=>({kind:`corner`,index:t,at:e})),...i]}function zy(e,t,n){switch(e.type){case`sides`:{let r=Hy([-e.x/2,e.x/2],[-e.y/2,e.y/2],t,n),i=2*Math.abs(t.at[0]<0?r.x[0]:r.x[1]),a=2*Math.abs(t.at[1]<0?r.y[0]:r.y[1]);return i>0&&a>0?{...e,x:t.along===`y`?e.x:i,y:t.along===`x`?e.y:a}:null}case`box`:{let{x:r,y:i}=Hy(e.x,e.y,t,n);return r[0]===r[1]||i[0]===i[1]?null:{...e,x:Uy(r),y:Uy(i)}}case`circle`:{let t=Math.hypot(n[0]-e.centre[0],n[1]-e.centre[1]);return t>0?{...e,radius:t}:null}case`segment`:return t.index===0?{...e,start:n}:{...e,end:n};case`line`:{let r=By(e.points,t,n);return e.bulges?{...e,points:r,bulges:Vy(e.bulges,t)}:{...e,points:r}}case`polygon`:return{...e,points:By(e.points,t,n),bulges:Vy(e.bulges,t)};default:return e}}function By(e,t,n){return t.kind===`add`?e.toSpliced(t.index+1,0,n):e.with(t.index,n)}function Vy(e,t){return t.kind===`add`&&e.length>t.index?e.toSpliced(t.index+1,0,0):e}function Hy(e,t,n,r){let i=n.kind===`edge`?n.index===0:n.index===0||n.index===3,a=n.kind===`edge`?n.index===2:n.index<2,o=n.along!==`y`,s=n.along!==`x`;return{x:[o&&i?r[0]:e[0],o&&!i?r[0]:e[1]],y:[s&&a?r[1]:t[0],s&&!a?r[1]:t[1]]}}function Uy([e,t]){return e<t?[e,t]:[t,e]}function Wy(e,t){if(e.type===`line`&&e.points.length>2){let n=e.points.toSpliced(t,1);return e.bulges?{...e,points:n,bulges:e.bulges.toSpliced(Math.min(t,e.points.length-2),1)}:{...e,points:n}}if(e.type!==`polygon`||e.points.length<=3)return null;let n=e.bulges.length>t?e.bulges.toSpliced(t,1):e.bulges;return{...e,points:e.points.toSpliced(t,1),bulges:n}}function Gy(e,t,n){let r=[];for(let i of e){let e=Ky(i,t,n);e!==null&&r.push({item:i,rank:e})}return r.sort((e,t)=>e.rank-t.rank).map(e=>e.item)}function Ky(e,t,n){let r=Qv(e.geometry);if(e.geometry.type===`point`){let r=Math.hypot(t[0]-e.geometry.x,t[1]-e.geometry.y);return r<=n||e.foot!==null&&ry(e.foot,t)?(e.kind===`column`?0:1)+r/(1+r)/2:null}let i=ty(e.geometry),a=1/0;if(r.forEach((e,n)=>{let o=r[n+1]??(i?r[0]:void 0);o&&(a=Math.min(a,iy(e,o,t).distance))}),a<=n)return(i?3:2)+a/(1+a)/2;if(!i||!ry(r,t))return null;let o=Math.abs(ny(r));return(e.kind===`slab`?20:10)+o/(1+o)}var qy=26;function Jy(e,t,n){let r=new Map;for(let e of t.filter(e=>e.kind===`load`))r.set(Yy(e),[...r.get(Yy(e))??[],e]);return t.map(t=>{let i=Z_(`g`,{class:Xy(t,n),"data-path":Dv(t.path),"data-kind":t.kind});return i.append(...Zy(e,t,r,n)),i})}function Yy({geometry:e}){return e.type===`point`?`${e.x} ${e.y}`:JSON.stringify({...e,at:0})}function Xy(e,t){let n=Ov(e.path),r=[t.selected&&Ov(t.selected)===n?`selected`:``,t.hovered&&Ov(t.hovered)===n?`hovered`:``,t.faulty.some(t=>Ov(t).startsWith(n)&&t.length>=e.path.length&&e.kind!==`slab`)?`faulty`:``,e.kind===`load`&&t.loadCase&&e.table.case!==t.loadCase?`faint`:``];return[`thing`,e.kind.replaceAll(` `,`-`),...r.filter(Boolean)].join(` `)}function Zy(e,t,n,r){let i=Qv(t.geometry).map(t=>e.toPixel(t));switch(t.kind){case`slab`:return[$y(i)];case`opening`:return[$y(i),...ab(i)];case`zone`:return[$y(i),...t.table.thickness===void 0?[]:[tb(rb(i),`t = ${String(t.table.thickness)}`,[0,13],`label middle`)]];case`soil zone`:case`void`:return[$y(i),tb(nb(i),t.title,[5,13])];case`column`:return ob(e,t,i);case`support`:return t.geometry.type===`point`?sb(i[0]??[0,0],t.table):[eb(i,!1),...cb(i),tb(ib(i),Qy(t),[6,14])];case`load`:return ub(e,t,i,n,r);case`borehole`:return gb(i[0]??[0,0],Qy(t));case`strip`:return _b(e,t,i);case`section line`:return[eb(i,!1),...vb(i),tb(i[0]??[0,0],Qy(t),[6,-6])];case`output point`:case`gap`:return[...yb(i[0]??[0,0]),tb(i[0]??[0,0],Qy(t)||t.title,[7,-5])]}}function Qy(e){return typeof e.table.name==`string`?e.table.name:``}function $y(e){return eb(e,!0,`area`)}function eb(e,t,n=``){return Z_(`path`,{d:e.map(([e,t],n)=>`${n===0?`M`:`L`}${e.toFixed(1)} ${t.toFixed(1)}`).join(``)+(t?`Z`:``),class:n||null})}function tb([e,t],n,[r,i]=[0,0],a=`label`){return Z_(`text`,{x:(e+r).toFixed(1),y:(t+i).toFixed(1),class:a},n)}function nb(e){return[Math.min(...e.map(e=>e[0])),Math.min(...e.map(e=>e[1]))]}function rb(e){let t=e.map(e=>e[0]);return[(Math.min(...t)+Math.max(...t))/2,nb(e)[1]]}function ib(e){let[t,n]=[e[Math.floor((e.length-1)/2)]??[0,0],e[Math.ceil((e.length-1)/2)]??[0,0]];return[(t[0]+n[0])/2,(t[1]+n[1])/2]}function ab(e){if(e.length!==4)return[];let[t,n,r,i]=e;return[eb([t,r],!1,`fine`),eb([n,i],!1,`fine`)]}function ob(e,t,n){let r=n[0]??[0,0],i=t.foot?.map(t=>e.toPixel(t))??[],a=i.length>0?Math.max(...i.map(([e,t])=>Math.max(Math.abs(e-r[0]),Math.abs(t-r[1])))):0;return[a<3.5?Z_(`rect`,{x:r[0]-3.5,y:r[1]-3.5,width:7,height:7}):$y(i),tb(r,Qy(t),[Math.max(a,4)+4,Math.max(a,4)+9])]}function sb([e,t],n){return[$y([[e,t],[e-7,t+12],[e+7,t+12]]),n.stiffness===void 0?eb([[e-9,t+15],[e+9,t+15]],!1,`fine`):eb([[e-7,t+15],[e-3.5,t+19],[e,t+15],[e+3.5,t+19],[e+7,t+15]],!1,`fine`),tb([e,t],typeof n.name==`string`?n.name:``,[11,16])]}function cb(e){let t=[];return lb(e,9,([e,n],[r,i])=>t.push(eb([[e,n],[e-i*5-r*5,n+r*5-i*5]],!1,`fine`))),t}function lb(e,t,n){e.slice(1).forEach((r,i)=>{let a=e[i],o=Math.hypot(r[0]-a[0],r[1]-a[1]);if(o===0)return;let s=[(r[0]-a[0])/o,(r[1]-a[1])/o],c=Math.min(400,Math.max(1,Math.round(o/t)));for(let e=0;e<=c;e+=1)n([a[0]+(r[0]-a[0])*e/c,a[1]+(r[1]-a[1])*e/c],s)})}function ub(e,t,n,r,i){let a=r.get(Yy(t))??[t],o=a.filter(e=>!i.loadCase||e.table.case===i.loadCase),s=a.find(e=>pb(i.selected,e)||pb(i.hovered,e)),c=t===(s??o[0]??a[0]),l=s&&o.length===0?[s]:o,u=c?s||o.length<2?l.map(mb):[`${o.length} loads`]:[];if(t.geometry.type===`point`){let r=t.foot?[$y(t.foot.map(t=>e.toPixel(t)))]:[];return c?[...r,...fb(t,n[0]??[0,0],u)]:r}let d=(e,t,n,r)=>u.map((i,a)=>tb(e,i,[t,n+12*(r?a-u.length+1:a)])),f=t.table.kind===`line`;if(ty(t.geometry)&&!f)return[$y(n),...db(e,t),...d(nb(n),5,13,!1)];ty(t.geometry)&&(n=[...n,...n.slice(0,1)]);let p=[];return lb(n,16,([e,t])=>p.push(eb([[e,t],[e,t-11]],!1,`fine`),eb([[e-2.5,t-4.5],[e,t],[e+2.5,t-4.5]],!1,`fine`))),[eb(n,!1,`wall`),eb(n.map(([e,t])=>[e,t-11]),!1,`fine`),...p,...d(n[0]??[0,0],4,-15,!0)]}function db(e,t){return Ev(t.table,[`holes`]).flatMap((n,r)=>{let i=Yv(t.table,[`holes`,r]);return i?[eb(Qv(i).map(t=>e.toPixel(t)),!0,`hole`)]:[]})}function fb(e,[t,n],r){let i=[t-3,n-3],a=[t-3-qy*.62,n-3-qy],[o,s]=String(e.table.P??``).trim().startsWith(`-`)?[a,i]:[i,a];return[eb([s,o],!1),hb(s,o),...r.map((e,t)=>tb(a,e,[0,-4-12*(r.length-1-t)],`label middle`))]}function pb(e,t){return e!==null&&Ov(e)===Ov(t.path)}function mb(e){if(e.table.kind!==`point`)return[Qy(e),String(e.table.q??``)].filter(Boolean).join(`  `).replace(`-`,`−`);let t=[`M_x`,`M_y`].filter(t=>e.table[t]!==void 0).map(t=>`, ${t.replace(`_`,``)} ${String(e.table[t])}`);return`${String(e.table.P??``)}${t.join(``)}`.replace(`-`,`−`)}function hb(e,t){let n=Math.hypot(t[0]-e[0],t[1]-e[1])||1,[r,i]=[(t[0]-e[0])/n,(t[1]-e[1])/n],a=e=>[t[0]-r*8-i*3.5*e,t[1]-i*8+r*3.5*e];return eb([t,a(1),a(-1)],!0,`head`)}function gb([e,t],n){return[Z_(`circle`,{cx:e,cy:t,r:7}),Z_(`path`,{d:`M${e} ${t}L${e} ${t-7}A7 7 0 0 1 ${e+7} ${t}ZM${e} ${t}L${e} ${t+7}A7 7 0 0 1 ${e-7} ${t}Z`,class:`filled`}),tb([e,t],n,[10,-4])]}function _b(e,t,n){let r=n[0]??[0,0],i=n[1]??r,a=Math.hypot(i[0]-r[0],i[1]-r[1]),o=(Pv(t.table.width)??0)/2*e.scale;if(a===0)return[];let[s,c]=[-(i[1]-r[1])/a*o,(i[0]-r[0])/a*o];return[$y([[r[0]+s,r[1]+c],[i[0]+s,i[1]+c],[i[0]-s,i[1]-c],[r[0]-s,r[1]-c]]),eb(n,!1),tb(r,Qy(t),[6,-6])]}function vb(e){let[t,n]=[e[0],e[1]];if(!t||!n)return[];let r=Math.hypot(n[0]-t[0],n[1]-t[1])||1,[i,a]=[-(n[1]-t[1])/r*6,(n[0]-t[0])/r*6];return[t,n].map(([e,t])=>eb([[e-i,t-a],[e+i,t+a]],!1))}function yb([e,t]){return[eb([[e-5,t],[e+5,t]],!1),eb([[e,t-5],[e,t+5]],!1)]}function bb(e,t,n){let r=[],i=n?xb(t)?2:t.length:t.length-1;if(i>24)return r;let a=t.reduce((t,[n])=>t+e.toPixel([n,0])[0],0)/Math.max(1,t.length);for(let n=0;n<i;n+=1){let[i,o]=[t[n],t[(n+1)%t.length]];if(!i||!o)continue;let s=Math.hypot(o[0]-i[0],o[1]-i[1]),[c,l]=[e.toPixel(i),e.toPixel(o)];if(Math.hypot(l[0]-c[0],l[1]-c[1])<34)continue;let u=Math.abs(l[1]-c[1])>Math.abs(l[0]-c[0]),d=[(c[0]+l[0])/2,(c[1]+l[1])/2],f=d[0]>a;r.push(tb(d,`${Rv(s,3)} m`,u?[f?-8:8,-8]:[0,-8],`label dimension ${u?f?`end`:``:`middle`}`))}return r}function xb(e){let[t,n,r,i]=e;return e.length===4&&!!t&&!!n&&!!r&&!!i&&t[1]===n[1]&&n[0]===r[0]&&r[1]===i[1]&&i[0]===t[0]}function Sb(e,t){return e.reduce((e,n)=>iy(n,n,t).distance<iy(e,e,t).distance?n:e,e[0]??t)}function Cb({at:e,points:t,step:n,reach:r}){let i=null,[a,o,s]=[r,r*.75,r*.75],[c,l]=[null,null];for(let n of t){let[t,r]=[Math.abs(n[0]-e[0]),Math.abs(n[1]-e[1])],u=Math.hypot(t,r);u<=a&&([i,a]=[n,u]),(t<o||t===o&&wb(n,c,e))&&([c,o]=[n,t]),(r<s||r===s&&wb(n,l,e))&&([l,s]=[n,r])}if(i)return{at:i,fromX:null,fromY:null,onPoint:!0};let u=Tb(e[0],n),d=Tb(e[1],n);return c&&Math.abs(u-e[0])<o&&n>=r/2&&(c=null),l&&Math.abs(d-e[1])<s&&n>=r/2&&(l=null),{at:[c?c[0]:u,l?l[1]:d],fromX:c,fromY:l,onPoint:!1}}function wb(e,t,n){return!t||Math.hypot(e[0]-n[0],e[1]-n[1])<Math.hypot(t[0]-n[0],t[1]-n[1])}function Tb(e,t){let n=Math.round(e/t)*t;return Number(n.toFixed(Math.max(0,3-Math.floor(Math.log10(t)))))+0}function Eb(e){let t=10**Math.floor(Math.log10(e)),n=[1,2,5,10].find(n=>n*t>=e*(1-1e-9))??10;return Number((n*t).toPrecision(1))}var Db=11,Ob=4.5,kb=70,Ab={left:40,bottom:20};function jb(e){return Eb(Ob/e.scale)}function Mb(e){let[t,n]=e.toPlan([0,0]),[r,i]=e.toPlan([e.width,e.height]),a=(a,o)=>{let s=``;for(let n of Pb(t,r,a))s+=`M${Math.round(e.toPixel([n,0])[0])+.5} 0V${e.height}`;for(let t of Pb(i,n,a))s+=`M0 ${Math.round(e.toPixel([0,t])[1])+.5}H${e.width}`;return Z_(`path`,{class:o,d:s})},[o,s]=e.toPixel([0,0]),c=Z_(`path`,{class:`axes`,d:`M${Math.round(o)+.5} 0V${e.height}M0 ${Math.round(s)+.5}H${e.width}`});return[a(Eb(Db/e.scale),`grid fine`),a(Eb(kb/e.scale),`grid`),c]}function Nb(e){let t=Eb(kb/e.scale),n=Math.max(0,-Math.floor(Math.log10(t)+1e-9)),[r,i]=e.toPlan([Ab.left,0]),[a,o]=e.toPlan([e.width,e.height-Ab.bottom]),s=[Z_(`rect`,{class:`ruler`,x:0,y:e.height-Ab.bottom,width:e.width,height:Ab.bottom}),Z_(`rect`,{class:`ruler`,x:0,y:0,width:Ab.left,height:e.height})];for(let i of Pb(r,a,t)){if(e.toPixel([i,0])[0]>e.width-54)break;s.push(tb([e.toPixel([i,0])[0],e.height-6],Rv(i,n).replace(`-`,`−`),[0,0],`figure middle`))}for(let r of Pb(o,i,t)){if(e.toPixel([0,r])[1]<28)break;s.push(tb([Ab.left-6,e.toPixel([0,r])[1]+4],Rv(r,n).replace(`-`,`−`),[0,0],`figure end`))}return s.push(tb([e.width-8,e.height-6],`x [m]`,[0,0],`figure end`),tb([Ab.left-6,13],`y [m]`,[0,0],`figure end`)),s}function*Pb(e,t,n){for(let r=Math.ceil(e/n);r<=Math.floor(t/n)&&r<1e9;r+=1)yield r*n}var Fb=9,Ib=8,Lb=class{store;camera=new Py;element;items=[];ghost=null;guides=null;hovered=null;corner=null;loadCase=``;layers=[`sheet`,`things`,`marks`,`figures`].map(e=>Z_(`g`,{class:`layer-${e}`}));fitted=!0;slab=``;frame=0;constructor(e){this.store=e,this.element=Z_(`svg`,{class:`drawing`,role:`application`,tabindex:0,"aria-label":`drawing of the slab in plan`,"aria-roledescription":`drawing`},...this.layers)}resize(e,t){e<1||t<1||(Object.assign(this.camera,{width:e,height:t}),this.fitted?this.fit():this.paint())}refresh(){this.items=uy(this.store.data,this.store.doc?.plan??null);let e=String(yy(this.items.filter(e=>e.kind===`slab`))),t=e!==this.slab;this.slab=e,t&&this.fitted&&!this.ghost?this.fit():this.paint()}fit(){let e=yy(this.items)??[-6,-4,6,4];this.camera.fit(e),this.camera.pan(Ab.left/2,-Ab.bottom/2),this.fitted=!0,this.paint()}moved(){this.fitted=!1,this.paint()}get selected(){return this.items.find(e=>kv(e.path,this.store.selection))??null}thingsAt(e){return Gy(this.items,this.camera.toPlan(e),Fb/this.camera.scale)}handleAt(e){let t=this.selected;if(!t)return null;let n=t=>{let[n,r]=this.camera.toPixel(t.at);return Math.hypot(n-e[0],r-e[1])};return Fy(t.geometry).filter(e=>n(e)<=Fb).sort((e,t)=>n(e)-n(t))[0]??null}snapped(e,t,n,r=[]){return t?{at:e,fromX:null,fromY:null,onPoint:!1}:Cb({at:e,points:[...by(this.items,n),...r],step:jb(this.camera),reach:Fb/this.camera.scale})}get reach(){return Fb/this.camera.scale}get step(){return jb(this.camera)}paint(){this.frame===0&&(this.frame=requestAnimationFrame(()=>{this.frame=0,this.paintNow()}))}paintNow(){let{camera:e,ghost:t}=this,[n,r,i,a]=this.layers;this.element.setAttribute(`width`,String(e.width)),this.element.setAttribute(`height`,String(e.height)),this.element.dataset.view=`${e.x} ${e.y} ${e.scale}`;let o={selected:this.store.selection,hovered:this.hovered,faulty:(this.store.doc?.faults??[]).map(e=>e.path),loadCase:this.loadCase},s=this.items.map(e=>t?.item&&kv(t.item.path,e.path)?Rb(e,t):e);n.replaceChildren(...Mb(e)),r.replaceChildren(...Jy(e,s,o)),i.replaceChildren(...this.marks(s)),a.replaceChildren(...Nb(e))}marks(e){let{camera:t,ghost:n}=this,r=e.find(e=>kv(e.path,this.store.selection)),i=[];if(r&&r.geometry.type!==`point`&&i.push(...bb(t,zb(r),ty(r.geometry))),r?.geometry.type===`point`&&!r.foot){let[e,n]=t.toPixel([r.geometry.x,r.geometry.y]);i.push(Z_(`circle`,{class:`halo`,cx:e,cy:n,r:11}))}return r&&!n&&i.push(...this.handles(r)),n&&i.push(...this.ghostMarks(n)),this.guides&&i.push(...this.guideMarks(this.guides)),i}handles(e){return Fy(e.geometry).map(e=>{let[t,n]=this.camera.toPixel(e.at),r=e.kind===`corner`&&e.index===this.corner,i=`handle ${e.kind}${r?` chosen`:``}`;return e.kind===`add`?Z_(`circle`,{class:i,cx:t,cy:n,r:3.5}):Z_(`rect`,{class:i,x:t-Ib/2,y:n-Ib/2,width:Ib,height:Ib})})}ghostMarks(e){let t=Qv(e.geometry),n=ty(e.geometry);if(e.item)return[];let r=t.map(e=>this.camera.toPixel(e)),i=r.slice(0,-1).map(([e,t])=>Z_(`circle`,{class:`drawn`,cx:e,cy:t,r:3}));return[eb(r,n,`ghost`),...n?[]:i,...bb(this.camera,t,n)]}guideMarks(e){let[t,n]=this.camera.toPixel(e.at),r=[];for(let i of[e.fromX,e.fromY])i&&r.push(eb([this.camera.toPixel(i),[t,n]],!1,`guide`));e.onPoint&&r.push(Z_(`circle`,{class:`on-point`,cx:t,cy:n,r:6}));let i=this.ghost?.words;if(i){let e=t>this.camera.width-220;r.push(tb([t,n],i,[e?-14:14,n<40?26:-14],e?`label tip end`:`label tip`))}return r}};function Rb(e,t){return{...e,geometry:t.geometry,foot:gy(e.table,t.geometry)}}function zb(e){return e.geometry.type===`circle`?[]:Qv(e.geometry.type===`polygon`?{...e.geometry,bulges:[]}:e.geometry)}var Bb=`Drag a rectangle, or click corner after corner and close with Enter.`,Vb=`Drag a straight line, or click place after place and end with Enter.`,Hb=[{name:`select`,label:`Select`,key:`V`,draws:`nothing`,hint:`Click to select, drag to move; drag the empty plan to shift it, turn the wheel to zoom.`},{name:`slab`,label:`Slab`,key:`B`,draws:`shape`,hint:`Draw the slab's outline anew. ${Bb}`},{name:`opening`,label:`Opening`,key:`O`,draws:`shape`,hint:`Cut an opening. ${Bb}`},{name:`zone`,label:`Thickness`,key:`T`,draws:`shape`,hint:`Draw a zone of another thickness. ${Bb}`},{name:`column`,label:`Column`,key:`C`,draws:`point`,hint:`Click where columns stand. Escape ends.`},{name:`point load`,label:`Point load`,key:`P`,draws:`point`,hint:`Click a place or a column. Escape ends.`},{name:`line load`,label:`Line load`,key:`L`,draws:`line`,hint:Vb},{name:`area load`,label:`Area load`,key:`A`,draws:`shape`,hint:Bb},{name:`support`,label:`Support`,key:`S`,draws:`point`,hint:`Click where the slab is supported at a point. Escape ends.`},{name:`wall`,label:`Line support`,key:`W`,draws:`line`,hint:Vb},{name:`borehole`,label:`Borehole`,key:`H`,draws:`point`,hint:`Click where layers are known. Escape ends.`},{name:`soil zone`,label:`Soil zone`,key:`G`,draws:`shape`,hint:`Draw a part of the plan with other ground. ${Bb}`},{name:`void`,label:`Void`,key:`U`,draws:`shape`,hint:`Draw where the ground lies deeper. ${Bb}`},{name:`section line`,label:`Section`,key:`X`,draws:`segment`,hint:`Drag the line along which values are listed.`}];function Ub(e){return Hb.find(t=>t.name===e)??Hb[0]}var Wb=e=>[zv(e[0]),zv(e[1])];function Gb(e){if(e.kind===`polygon`)return{kind:`polygon`,points:e.points.map(Wb)};let[t,n]=[0,1].map(t=>[e.from[t]??0,e.to[t]??0].sort((e,t)=>e-t).map(e=>zv(e)));return{kind:`rectangle`,x:t??[],y:n??[]}}function Kb(e,t,n,r){return{change:{edits:[{op:`add`,path:t,value:n}],text:`add ${r}`},path:[...t,Ev(e,t).length]}}function qb(e,t,n,r){let i=Gb(n);switch(e){case`opening`:return Kb(t,[`plate`,`openings`],i,`opening`);case`zone`:return Kb(t,[`plate`,`zones`],{...ky(`Zone`,t),shape:i},`zone`);case`soil zone`:return Kb(t,[`soil_zones`],{shape:i,ground:$b(t)},`soil zone`);case`void`:return Kb(t,[`contact`,`voids`],{...ky(`Void`,t),...i.kind===`rectangle`?{x:i.x,y:i.y}:{shape:i}},`void`);case`area load`:return Kb(t,[`loads`],i.kind===`rectangle`?{...ky(`PatchLoad`,t),...Qb(r),x:i.x,y:i.y}:{...ky(`AreaLoad`,t),...Qb(r),shape:i},`area load`);default:return{change:{edits:Jb(t,i),text:`draw the slab`},path:[`plate`,`outline`]}}}function Jb(e,t){let n=Tv(e,[`plate`]),r=[`length_x`,`length_y`].filter(e=>e in n).map(e=>({op:`remove`,path:[`plate`,e]}));for(let[t,i]of Object.entries(ky(`Plate`,e)))!(t in n)&&!t.startsWith(`length`)&&r.push({op:`set`,path:[`plate`,t],value:i});return[...r,{op:`set`,path:[`plate`,`outline`],value:t}]}function Yb(e,t,n,r){let i={points:n.map(Wb)};if(e===`wall`)return Kb(t,[`supports`],{...ky(`LineSupport`,t),...i},`line support`);if(e===`section line`){let e=ex(Jv(Ev(t,[`output`,`lines`])),`line 1`),r=n[0]??[0,0],i=n.at(-1)??r;return Kb(t,[`output`,`lines`],{name:e,start:Wb(r),end:Wb(i)},`section ${e}`)}return Kb(t,[`loads`],{...ky(`LineLoad`,t),...Qb(r),...i},`line load`)}function Xb(e,t,n,r){let i={x:zv(n[0]),y:zv(n[1])};if(e===`support`)return Kb(t,[`supports`],{...ky(`PointSupport`,t),...i},`point support`);if(e===`borehole`){let e=ex(Jv(Ev(t,[`boreholes`])),`B1`),n=Ev(t,[`boreholes`,0,`layers`]),r=n.length>0?n:Ev(t,[`ground`,`layers`]);return Kb(t,[`boreholes`],{name:e,...i,layers:r.length>0?r:ky(`Borehole`,t).layers??[]},`borehole ${e}`)}if(e===`column`){let e=Ev(t,[`columns`]).findLast(Cv),n=ex(Jv(Ev(t,[`columns`])),`C1`),r=e&&(e.diameter??e.width_x)!==void 0?Object.fromEntries(Object.entries(e).filter(([e])=>[`diameter`,`width_x`,`width_y`].includes(e))):{width_x:`400 mm`,width_y:`400 mm`};return Kb(t,[`columns`],{name:n,...i,...r},`column ${n}`)}let a=Zb(t,n),o=a===null?i:{column:a};return Kb(t,[`loads`],{...ky(`PointLoad`,t),...Qb(r),...o},`point load`)}function Zb(e,t){for(let n of Ev(e,[`columns`])){if(!Cv(n)||typeof n.name!=`string`||!n.name)continue;let[e,r]=[Pv(n.x),Pv(n.y)];if(e===null||r===null)continue;let i=gy(n,{type:`point`,at:[],x:e,y:r});if(Math.hypot(e-t[0],r-t[1])<1e-9||i&&ry(i,t))return n.name}return null}function Qb(e){return e?{case:e}:{}}function $b(e){let t=Tv(e,[`ground`]);return Object.keys(t).length>0?structuredClone(t):ky(`Winkler`,e)}function ex(e,t){let n=/^(.*?)(\d+)$/.exec(t),[r,i]=n?[n[1]??``,Number(n[2])]:[`${t} `,2];if(!e.includes(t))return t;let a=i;for(;e.includes(`${r}${a}`);)a+=1;return`${r}${a}`}function tx(e,t,n,r){let i=t.slice(0,-1),a=t.at(-1),o=Tv(e,t);if(typeof a!=`number`||Object.keys(o).length===0)return null;let s=structuredClone(o),c=Jv(Ev(e,i));typeof s.name==`string`&&s.name&&(s.name=ex(c,s.name));let l=Ev(e,i).length,u=[{op:`add`,path:i,value:s}];return(r[0]!==0||r[1]!==0)&&u.push({op:`move`,path:[...i,l],by:r}),{change:{edits:u,text:`duplicate ${n}`},path:[...i,l]}}var nx=class{item;start;held;by=[0,0];constructor(e,t){this.item=e,this.start=t,this.held=Sb(Qv(e.geometry),t)}wanted(e){return[this.held[0]+e[0]-this.start[0],this.held[1]+e[1]-this.start[1]]}to({at:e}){this.by=[lx(e[0]-this.held[0]),lx(e[1]-this.held[1])];let t=`${sx(e)}   Δ ${cx(this.by[0])}, ${cx(this.by[1])} m`;return{geometry:oy(this.item.geometry,this.by),item:this.item,words:t}}change(){return this.by[0]===0&&this.by[1]===0?null:{edits:[{op:`move`,path:this.item.path,by:this.by}],text:`move ${this.item.title}`}}},rx=class{item;handle;after;constructor(e,t){this.item=e,this.handle=t,this.after=e.geometry}to({at:e}){return this.after=zy(this.item.geometry,this.handle,e)??this.after,{geometry:this.after,item:this.item,words:`${sx(e)}   ${ax(this.after)}`}}change(){let e=sy(this.item.geometry,this.after);return e.length===0?null:{edits:e,text:`${this.handle.kind===`add`?`add a corner to`:`reshape`} ${this.item.title}`}}},ix=class{tool;points=[];dragging=!1;constructor(e){this.tool=e}down(e,t){let[n]=this.points,r=this.points.at(-1);if(this.tool.draws===`point`)return this.points.push(e),!0;let i=this.tool.draws===`shape`&&n&&this.points.length>=3&&ox(n,e,t),a=this.tool.draws===`line`&&r&&this.points.length>=2&&ox(r,e,t);return i||a?!0:(r&&ox(r,e,1e-9)||this.points.push(e),this.dragging=this.points.length===1,this.tool.draws===`segment`&&this.points.length===2)}up(e,t){let[n]=this.points,r=this.dragging&&n&&!ox(n,e,t);return this.dragging=!1,r?(this.points.push(e),!0):!1}get boxed(){return this.tool.draws===`shape`&&this.points.length===2}ghost({at:e}){let t=[...this.points,e],[n]=this.points;if(!n)return{geometry:{type:`point`,at:[],x:e[0],y:e[1]},item:null,words:sx(e)};let r=`${Rv(Math.abs(e[0]-n[0]),3)} × ${Rv(Math.abs(e[1]-n[1]),3)} m`;if(this.tool.draws===`shape`&&this.dragging)return{geometry:{type:`box`,at:[],x:[n[0],e[0]],y:[n[1],e[1]]},item:null,words:`${sx(e)}   ${r}`};let i=this.points.at(-1)??n,a=Math.hypot(e[0]-i[0],e[1]-i[1]),o=Math.atan2(e[1]-i[1],e[0]-i[0])*180/Math.PI;return{geometry:{type:`line`,at:[],points:t},item:null,words:`${sx(e)}   ${Rv(a,3)} m at ${Rv(o,1)}°`}}made(e,t){let{tool:n,points:r}=this,[i,a]=r;if(!i)return null;if(n.draws===`point`)return Xb(n.name,e,i,t);if(!a)return null;if(n.draws===`line`||n.draws===`segment`)return Yb(n.name,e,r,t);if(this.boxed&&(i[0]===a[0]||i[1]===a[1])||!this.boxed&&r.length<3)return null;let o=this.boxed?{kind:`rectangle`,from:i,to:a}:{kind:`polygon`,points:r};return qb(n.name,e,o,t)}};function ax(e){switch(e.type){case`sides`:return`${Rv(e.x,3)} × ${Rv(e.y,3)} m`;case`box`:return`${Rv(e.x[1]-e.x[0],3)} × ${Rv(e.y[1]-e.y[0],3)} m`;case`circle`:return`r = ${Rv(e.radius,3)} m`;case`point`:return sx([e.x,e.y]);default:{let t=Qv(e),n=ty(e)?[...t,...t.slice(0,1)]:t,r=n.slice(1).reduce((e,t,r)=>e+Math.hypot(t[0]-(n[r]?.[0]??0),t[1]-(n[r]?.[1]??0)),0);return ty(e)?`${t.length} corners`:`${Rv(r,3)} m long`}}}function ox(e,t,n){return Math.hypot(e[0]-t[0],e[1]-t[1])<=n}function sx([e,t]){return`x ${zv(e)}, y ${zv(t)}`.replaceAll(`-`,`−`)}function cx(e){return`${e<0?`−`:`+`}${Rv(Math.abs(e),3)}`}function lx(e){return Number(e.toFixed(6))+0}var ux=4,dx=class{canvas;store;hooks;drawing=null;press=null;space=!1;lastClick=null;touches=new Map;constructor(e,t,n){this.canvas=e,this.store=t,this.hooks=n;let{element:r}=e;r.addEventListener(`pointerdown`,e=>this.down(e)),r.addEventListener(`pointermove`,e=>this.move(e)),r.addEventListener(`pointerup`,e=>this.up(e)),r.addEventListener(`pointercancel`,()=>this.cancel()),r.addEventListener(`pointerleave`,()=>this.leave()),r.addEventListener(`wheel`,e=>this.wheel(e),{passive:!1}),r.addEventListener(`contextmenu`,e=>e.preventDefault()),r.addEventListener(`dblclick`,()=>this.finish()),r.addEventListener(`keydown`,e=>{e.key===` `&&(this.space=!0)}),r.addEventListener(`keyup`,e=>{e.key===` `&&(this.space=!1)})}finish(){!this.drawing||this.drawing.points.length<2||this.complete()}cancel(){let e=this.press!==null||this.drawing!==null;return this.press=null,this.drawing=null,this.canvas.ghost=null,this.canvas.guides=null,this.canvas.paint(),e}pixel(e){let t=this.canvas.element.getBoundingClientRect();return[e.clientX-t.left,e.clientY-t.top]}down(e){let{canvas:t}=this;t.element.focus({preventScroll:!0}),t.element.setPointerCapture(e.pointerId);let n=this.pixel(e);if(this.touches.set(e.pointerId,n),this.touches.size>1||e.button>0||this.space){this.press={kind:`pan`,last:n};return}let r=this.hooks.tool();if(r.draws!==`nothing`){if(!this.hooks.editable())return;this.drawing??=new ix(r);let i=t.snapped(t.camera.toPlan(n),e.altKey,null,this.drawing.points).at;this.drawing.down(i,t.reach)&&this.complete();return}let i=t.handleAt(n),a=t.selected;if(i&&a&&this.hooks.editable()){t.corner=i.kind===`corner`?i.index:null,this.press={kind:`reshape`,reshaping:new rx(a,i)},t.paint();return}let o=t.thingsAt(n),s=this.lastClick!==null&&!fx(this.lastClick,n)?o.find(e=>kv(e.path,this.store.selection)):void 0,c=s??o[0];this.press=c?{kind:`thing`,item:c,start:n,wasSelected:s!==void 0}:{kind:`empty`,start:n}}move(e){let{canvas:t,press:n}=this,r=this.pixel(e),i=this.touches.get(e.pointerId);if(i&&this.touches.size>1)return this.pinch(e.pointerId,i,r);if(n?.kind===`pan`)t.camera.pan(r[0]-n.last[0],r[1]-n.last[1]),n.last=r,t.moved();else if((n?.kind===`thing`||n?.kind===`empty`)&&fx(n.start,r))this.startDrag(n,r);else if(n?.kind===`move`){let i=t.snapped(n.moving.wanted(t.camera.toPlan(r)),e.altKey,n.moving.item.path);t.guides=i,t.ghost=n.moving.to(i),t.paint()}else if(n?.kind===`reshape`){let i=t.snapped(t.camera.toPlan(r),e.altKey,n.reshaping.item.path);t.guides=i,t.ghost=n.reshaping.to(i),t.paint()}else!n&&this.hooks.tool().draws!==`nothing`?this.hoverTool(r,e.altKey):n||this.hover(r)}startDrag(e,t){let n=e.kind===`thing`&&kv(e.item.path,this.store.selection),r=e.kind===`thing`&&(e.item.kind!==`slab`||n);e.kind===`empty`||!r?(this.press={kind:`pan`,last:e.start},this.canvas.camera.pan(t[0]-e.start[0],t[1]-e.start[1]),this.press.last=t,this.canvas.moved()):(this.hooks.select(e.item.path),!e.item.movable||!this.hooks.editable()?(this.hooks.say(px(e.item)),this.press=null):this.press={kind:`move`,moving:new nx(e.item,this.canvas.camera.toPlan(e.start))})}hoverTool(e,t){let{canvas:n}=this,r=this.drawing??new ix(this.hooks.tool()),i=n.snapped(n.camera.toPlan(e),t,null,r.points);n.guides=i,n.ghost=r.ghost(i),n.paint()}hover(e){let{canvas:t}=this,n=t.handleAt(e),r=n?null:t.thingsAt(e)[0]??null;t.element.dataset.cursor=n?n.along??n.kind:r&&r.kind!==`slab`?`thing`:``,kv(t.hovered,r?.path??null)||(t.hovered=r?.path??null,t.paint())}leave(){this.press||(this.canvas.hovered=null,this.canvas.guides=null,this.drawing||(this.canvas.ghost=null),this.canvas.paint())}up(e){let{canvas:t,press:n}=this,r=this.pixel(e);if(this.touches.delete(e.pointerId),this.press=null,this.drawing){let n=t.snapped(t.camera.toPlan(r),e.altKey,null,this.drawing.points).at;this.drawing.up(n,t.reach)&&this.complete()}if(n?.kind===`move`||n?.kind===`reshape`){let e=n.kind===`move`?n.moving.change():n.reshaping.change();t.ghost=null,t.guides=null,e&&this.hooks.push(e),t.paint()}else n?.kind===`thing`?this.click(n.item,n.wasSelected,r):n?.kind===`empty`&&this.hooks.select(null)}click(e,t,n){if(this.canvas.corner=null,this.lastClick=n,!t)return this.hooks.select(e.path);let r=this.canvas.thingsAt(n),i=r[(r.findIndex(t=>kv(t.path,e.path))+1)%r.length];this.hooks.select(i?.path??e.path)}complete(){let e=this.drawing?.made(this.store.data,this.canvas.loadCase);this.cancel(),e&&this.hooks.drawn(e.change,e.path)}wheel(e){e.preventDefault();let t=e.deltaMode===1?16:1;this.canvas.camera.zoom(Math.exp(-e.deltaY*t*.0015),this.pixel(e)),this.canvas.moved()}pinch(e,t,n){let r=[...this.touches].find(([t])=>t!==e)?.[1];if(this.touches.set(e,n),!r)return;let i=e=>Math.hypot(e[0]-r[0],e[1]-r[1])||1;this.canvas.camera.pan((n[0]-t[0])/2,(n[1]-t[1])/2),this.canvas.camera.zoom(i(n)/i(t),[(n[0]+r[0])/2,(n[1]+r[1])/2]),this.press={kind:`pan`,last:n},this.canvas.moved()}};function fx(e,t){return Math.hypot(e[0]-t[0],e[1]-t[1])>ux}function px(e){return e.kind===`slab`?`A rectangle by its sides lies about the origin: drag its edges, or change it into a polygon to move it.`:e.kind===`load`?`It stands on column ${String(e.table.column)} and goes with it.`:`It cannot be moved at present.`}var mx=class{canvas;push;by=[0,0];timer=null;constructor(e,t){this.canvas=e,this.push=t}step(e,t,n){this.by=[this.by[0]+t,this.by[1]+n],this.canvas.ghost={geometry:oy(e.geometry,this.by),item:e,words:``},this.canvas.paint(),this.timer!==null&&clearTimeout(this.timer),this.timer=setTimeout(()=>this.flush(e),350)}flush(e){let t=this.by.map(e=>Number(e.toFixed(6)));this.by=[0,0],this.timer=null,this.canvas.ghost=null,(t[0]!==0||t[1]!==0)&&this.push({edits:[{op:`move`,path:e.path,by:t}],text:`move ${e.title}`}),this.canvas.paint()}};function hx(e,t){return e.filter(e=>Av(e.path,t))}function gx(e,t,n){let r=new Set(n?.fields.map(e=>e.name)??[`kind`]);return hx(e,t).filter(e=>{let n=e.path[t.length];return n===void 0||typeof n==`string`&&!r.has(n)})}function _x(e,t){return hx(e,t).filter(e=>typeof e.path[t.length]!=`number`)}function vx(e){let t=e.mend?` — ${e.mend}`:``;return yx(`Got ${e.got}, expected ${e.expected}${t}`)}function yx(e){return/[.?!]$/.test(e)?e:`${e}.`}function bx(e,t,n,r,i){let a=Tv(e,t);n&&i.set(xx(t,n),a);let o=Sx(e,t,a,n,r,i.get(xx(t,r))??{});if(wv(e,t)===void 0)return[{op:`set`,path:t,value:o}];let s=[];r.kind&&s.push({op:`set`,path:[...t,`kind`],value:r.kind});for(let e of Object.keys(a))e in o||s.push({op:`remove`,path:[...t,e]});for(let[e,n]of Object.entries(o))e!==`kind`&&!jv(n,a[e])&&s.push({op:`set`,path:[...t,e],value:n});return s}function xx(e,t){return JSON.stringify([e,t.name])}function Sx(e,t,n,r,i,a){let o=i.kind?{kind:i.kind}:{},s=new Map((r?.fields??[]).map(e=>[e.name,e]));for(let e of i.fields){let t=n[e.name],r=s.get(e.name);t!==void 0&&e.node.is!==`tag`&&(!r||Cx(r,e))&&(o[e.name]=t)}let c={...Ex(e,t,i,n),...ky(i.name,e),...a},l=new Set(Object.keys({...ky(i.name,e),...a}));for(let e of i.fields){let t=c[e.name],n=e.needed||l.has(e.name)||Tx(i,e);o[e.name]===void 0&&t!==void 0&&n&&(o[e.name]=t)}return o}function Cx(e,t){let[n,r]=[wx(e.node),wx(t.node)];return JSON.stringify(e.node)===JSON.stringify(t.node)||e.node.is===t.node.is&&n.some(e=>r.includes(e))}function wx(e){return e.is===`list`?wx(e.of):e.is===`part`?[e.part]:e.is===`kinds`?e.parts:[]}function Tx(e,t){return e.name===`LineLoad`?t.name===`points`:[`PointLoad`,`Void`,`Circle`].includes(e.name)&&[`x`,`y`,`centre`].includes(t.name)}function Ex(e,t,n,r={}){let i=new Set(n.fields.map(e=>e.name)),[a,o,s,c]=Ox(e,t,r),[l,u]=[(a+s)/2,(o+c)/2],d=([e,t])=>[zv(e),zv(t)],f={x:[zv(a),zv(s)],y:[zv(o),zv(c)]};switch(n.name){case`Rectangle`:return{kind:`rectangle`,...f};case`Polygon`:return{kind:`polygon`,...Dx(e,t,[a,o,s,c],d)};case`Circle`:return{kind:`circle`,centre:d([l,u]),radius:zv(Math.min(s-a,c-o)/2)};case`LineLoad`:return{points:[d([a,u]),d([s,u])]};case`PatchLoad`:case`Void`:return f}let p={};return i.has(`shape`)&&(p.shape={kind:`rectangle`,...f}),i.has(`points`)&&(p.points=[d([a,u]),d([s,u])]),i.has(`start`)&&Object.assign(p,{start:d([a,u]),end:d([s,u])}),i.has(`x`)&&i.has(`y`)&&Object.assign(p,{x:zv(l),y:zv(u)}),n.name===`OutputStrip`&&(p.width=zv(Math.max(1,Math.round((c-o)/2)))),p}function Dx(e,t,[n,r,i,a],o){let s=t.length>0?Yv(e,t):null;if(s?.type!==`circle`)return{points:[[n,r],[i,r],[i,a],[n,a]].map(o)};let{centre:[c,l],radius:u}=s,d=[[c+u,l],[c,l+u],[c-u,l],[c,l-u]];return{points:d.map(o),bulges:d.map(()=>Math.tan(Math.PI/8))}}function Ox(e,t,n){let r=Object.keys(n).length>0?Yv(e,t)??Yv(e,[...t,`shape`]):null,i=r?ay(Qv(r)):null;if(i&&i[2]>i[0]&&i[3]>i[1])return i;let a=Xv(e)??Yv(e,[`plate`,`outline`]),[o,s,c,l]=(a?ay(Qv(a)):null)??[-3,-2,3,2];if(t[0]===`plate`&&t[1]===`outline`)return[o,s,c,l];let[u,d]=i?[(i[0]+i[2])/2,(i[1]+i[3])/2]:[(o+c)/2,(s+l)/2],f=Math.max(.1,Math.round(Math.min(c-o,l-s)*1.25)/10);return[u-f,d-f,u+f,d+f]}function kx(e,t,n,r=!1){if(jv(n,wv(e.data(),t)))return;let i={edits:[n===void 0?{op:`remove`,path:t}:{op:`set`,path:t,value:n},...typeof n==`string`?wy(e.data(),t,n):[]],text:`change ${jx(e.data(),t)}`};e.change(r?{...i,merge:!0}:i)}function Ax(e){return Cy(e)}function jx(e,t){let n=t.findLast(e=>typeof e==`string`)??``,r=t.slice(0,t.lastIndexOf(n));return r.length===0?String(n):`${String(n).replaceAll(`_`,` `)} of ${my(e,r)}`}var Mx={alpha:`α`,beta:`β`,gamma:`γ`,delta:`δ`,kappa:`κ`,nu:`ν`,psi:`ψ`,mu:`μ`,phi:`φ`},Nx=30;function Px(e){let t=Q(`i`,{class:`symbol`});return e.split(`, `).forEach((e,n)=>{let[r=``,i]=e.split(`_`);n>0&&t.append(`, `),t.append(Mx[r]??r),i&&t.append(Q(`sub`,{},Mx[i]??i))}),t}function Fx(e){let{name:t,hint:n}=e;if(t===`x`||t===`y`)return t;if(!(t.length<=2||t===e.symbol||/^[A-Za-z]{1,2}_/.test(t)))return t.replaceAll(`_`,` `);let r=(n.split(/[,;:]/)[0]??``).replace(/^its /,``).replace(/ there$/,``).trim();return r&&r.length<=Nx?r:``}function Ix(e){let t=e.replaceAll(`_`,` `);return t.charAt(0).toUpperCase()+t.slice(1)}function Lx(e){return e==null?``:Array.isArray(e)?e.length<=3?e.map(Lx).join(`, `):`${e.length} values`:Cv(e)?``:String(typeof e==`number`?Number(e.toPrecision(6)):e)}function Rx(e){return e===void 0||e===``?``:Lx(e).replace(/(\d)\.0(?= |$)/,`$1`).replace(/^1e-05/,`1e-5`)}function zx(e,t){let n=[];typeof e.name==`string`&&e.name&&n.push(e.name),typeof e.kind==`string`&&n.push(e.kind);for(let r of t?.fields??[]){if(n.length>=5||[`name`,`kind`,`case`,`column`].includes(r.name))continue;let t=e[r.name],i=[`quantity`,`number`,`whole`,`choice`,`tuple`].includes(r.node.is);t!==void 0&&i&&n.push(`${r.symbol&&r.name.length>2?``:`${r.name} `}${Lx(t)}`.trim())}return Cv(e.shape)&&n.push(String(e.shape.kind??``)),Cv(e.factors)&&n.push(Object.entries(e.factors).map(([e,t])=>`${Lx(t)} ${e}`).join(` + `)),typeof e.column==`string`&&e.column&&n.push(`on ${e.column}`),typeof e.case==`string`&&e.case&&n.push(`(${e.case})`),n.filter(Boolean).join(`  ·  `)}function Bx(e,t){let n=t.trim();if(n!==``)return e.is===`number`&&e.words.includes(n)?n:(e.is===`number`||e.is===`whole`)&&/^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$/.test(n)?Number(n):n}function Vx(e){return e==null?``:typeof e==`object`?JSON.stringify(e):String(e)}function Hx(e,t,n,r={}){let i=Q(`input`,{type:`text`,autocomplete:`off`,spellcheck:`false`,placeholder:r.placeholder??``,"aria-label":r.label,class:n.is===`text`?`wide`:`number`,inputmode:n.is===`number`||n.is===`whole`?`decimal`:null}),a=r.write??((n,r)=>kx(e,t,n,r)),o=!1,s=0,c=()=>{o=!1,a(Bx(n,i.value),s>0),s+=1},l=av(350,c),u=Ax(t);i.addEventListener(`focus`,()=>s=0),i.addEventListener(`input`,()=>{o=!0,u||l()});let d=()=>{l.flush(),o&&c()};i.addEventListener(`change`,d),i.addEventListener(`blur`,d),i.addEventListener(`keydown`,e=>{e.key===`Enter`&&d()});let f=Sy(e.data(),t)===null?null:Q(`datalist`,{id:iv(`names`)});return f&&i.setAttribute(`list`,f.id),{element:f?Q(`span`,{class:`with-names`},i,f):i,focus:i,update:()=>{f&&$(f,...(Sy(e.data(),t)??[]).map(e=>Q(`option`,{value:e})));let r=wv(e.data(),t);o||document.activeElement===i&&Bx(n,i.value)===r||i.value!==Vx(r)&&(i.value=Vx(r))}}}function Ux(e,t,n,r){let i=Q(`select`,{});return i.addEventListener(`change`,()=>kx(e,t,i.value===``?void 0:i.value)),{element:i,focus:i,update:()=>{let a=wv(e.data(),t),o=Vx(a??r),s=n.includes(o)?[]:[Q(`option`,{value:o},o===``?`choose …`:o)];$(i,...s,...n.map(e=>Q(`option`,{value:e},e))),i.value=o,i.classList.toggle(`by-default`,a===void 0),i.title=a===void 0&&r!==void 0?`by default`:``}}}function Wx(e,t,n){let r=Q(`input`,{type:`checkbox`,class:`flag`});return r.addEventListener(`change`,()=>kx(e,t,r.checked)),{element:r,focus:r,update:()=>{let i=wv(e.data(),t)??n;r.checked=i===!0,r.indeterminate=typeof i!=`boolean`}}}function Gx(e,t,n,r){let i=n.map(e=>Q(`input`,{type:`checkbox`,value:e})),a=Q(`span`,{class:`checks`,role:`group`},...i.map(e=>Q(`label`,{},e,e.value)));return a.addEventListener(`change`,()=>kx(e,t,i.filter(e=>e.checked).map(e=>e.value))),{element:a,focus:i[0]??a,update:()=>{let n=wv(e.data(),t)??r;for(let e of i)e.checked=Array.isArray(n)&&n.includes(e.value)}}}function Kx(e,t,n,r,i,a){let o=i=>(o,s)=>{let c=wv(e.data(),t),l=Array.from({length:r},(e,t)=>(Array.isArray(c)?c[t]:void 0)??qx(n,a,t));l[i]=o??``,kx(e,t,o===void 0&&l.every((e,t)=>e===``||!Array.isArray(c)&&t!==i)?void 0:l,s)},s=Array.from({length:r},(r,s)=>Hx(e,[...t,s],n,{label:i[s]??String(s+1),placeholder:Array.isArray(a)?Rx(a[s]):i[s]??``,write:o(s)})),c=Q(`span`,{class:`tuple`},...s.map(e=>e.element));return{element:c,focus:s[0]?.focus??c,update:()=>s.forEach(e=>e.update())}}function qx(e,t,n){let r=Array.isArray(t)?t[n]:void 0;return r===void 0?``:e.is!==`quantity`||typeof r!=`number`?r:`${r} ${e.example.replace(/^[-+.\deE]+\s*/,``)}`}function Jx(e,t){let n=e.symbol.split(`, `);return n.length===t?n.map(e=>e.replace(`_`,``)):t===2&&(e.name===`x`||e.name===`y`)?[`from`,`to`]:t===2&&e.hint.includes(`along x, along y`)?[`x`,`y`]:t===2&&e.hint.includes(`unfavourable and favourable`)?[`unfavourable`,`favourable`]:t===2?[`x`,`y`]:[]}function Yx(e,t,n){let r=Hx(e,t,{is:`text`},{placeholder:`0, 0, …`,write:(r,i)=>{let a=(typeof r==`string`||typeof r==`number`?String(r).split(`,`):[]).map(e=>Bx(n,e)).filter(e=>e!==void 0);kx(e,t,a.length>0?a:void 0,i)}}),i=r.focus,a=()=>{let n=wv(e.data(),t);document.activeElement!==i&&(i.value=Array.isArray(n)?n.map(Vx).join(`, `):Vx(n))};return{...r,update:a}}function Xx(e,t,n){let{node:r}=n,i=r.is===`quantity`?`e.g. ${r.example}`:``,a=n.default===void 0?n.needed?i:``:Rx(n.default);switch(r.is){case`choice`:return Ux(e,t,r.words,n.default);case`flag`:return Wx(e,t,n.default);case`several`:return Gx(e,t,r.words,n.default);case`tuple`:return Kx(e,t,r.each,r.length,Jx(n,r.length),n.default);case`values`:return Yx(e,t,r.each);default:return Hx(e,t,r,{placeholder:a||(r.is===`quantity`?`e.g. ${r.example}`:``)})}}function Zx(e,t,n,r,i){let a=hx(e.faults(),t);n.classList.toggle(`faulty`,a.length>0),a.length>0?r.setAttribute(`aria-invalid`,`true`):r.removeAttribute(`aria-invalid`);let o=a.map(vx);i.textContent!==o.join(``)&&$(i,...o.map(e=>Q(`p`,{},e)))}function Qx(e,t,n,r){return Av(n,t)?(r.scrollIntoView({block:`nearest`}),e.focus.focus(),!0):!1}function $x(e,t,n,r){let i=(r,i)=>{let a=Object.keys(Tv(e.data(),t)).filter(e=>e!==n);r===void 0&&a.length===0?kx(e,t,void 0,i):kx(e,[...t,n],r,i)};return Hx(e,[...t,n],{is:`number`,words:[]},{label:r,placeholder:`–`,write:i})}function eS(e,t,n,r){let i=$x(e,t,n,r),a=[...t,n],o=Q(`div`,{class:`messages`,id:iv(`fault`)});i.focus.setAttribute(`aria-describedby`,o.id);let s=Q(`div`,{class:`cell`,"data-path":Dv(a)},i.element,o);return{element:s,update:()=>{i.update(),Zx(e,a,s,i.focus,o)},reveal:e=>Qx(i,a,e,s)}}function tS(e,t){let n=Q(`span`,{class:`factors`}),r=[],i=[],a=()=>{i=r.map(n=>$x(e,t,n,`factor of ${n}`)),$(n,...i.map((e,t)=>Q(`label`,{},Q(`span`,{},r[t]??``),e.element))),r.length===0&&$(n,Q(`span`,{class:`quiet`},`Add load cases first.`))};return{element:n,get focus(){return i[0]?.focus??n},update:()=>{let n=Object.keys(Tv(e.data(),t)),o=[...new Set([...Jv(Ev(e.data(),[`cases`])),...n])];(i.length===0||o.join(`
`)!==r.join(`
`))&&(r=o,a());for(let e of i)e.update()}}}var nS=4;function rS(e,t,n){let r=Q(`div`,{class:`place-rows`}),i=Q(`summary`,{}),a=Q(`button`,{type:`button`,class:`small`,onclick:()=>l(Ev(e.data(),t).length)},`Add place`),o=Q(`details`,{class:`place-fold`},i,r,a),s=Q(`div`,{class:`places`},o),c=[],l=n=>{let r=Ev(e.data(),t);kx(e,t,r.toSpliced(n,0,iS(r[n-1],r[n]??r[0])))},u=n=>{let r=Ev(e.data(),t).toSpliced(n,1);kx(e,t,r.length>0?r:void 0)},d=a=>{c.length===0&&(o.open=a<=nS),i.textContent=a===1?`1 place`:`${a} places`,c=Array.from({length:a},(r,i)=>Kx(e,[...t,i],n,2,[`x`,`y`],void 0)),$(r,...c.map((e,t)=>Q(`div`,{class:`place-row`},Q(`span`,{class:`number-of`},String(t+1)),e.element,Q(`button`,{type:`button`,class:`icon`,"aria-label":`insert a place after ${t+1}`,title:`insert after`,onclick:()=>l(t+1)},tv(`add`)),Q(`button`,{type:`button`,class:`icon`,"aria-label":`remove place ${t+1}`,title:`remove`,onclick:()=>u(t)},tv(`remove`)))))};return{element:s,get focus(){return o.open?c[0]?.focus??a:i},update:()=>{let{length:n}=Ev(e.data(),t);n!==c.length&&d(n);for(let e of c)e.update()}}}function iS(e,t){let[n,r]=[Fv(e),Fv(t)];return!n||!r?[`0 m`,`0 m`]:Bv(e,[(n[0]+r[0])/2,(n[1]+r[1])/2])}function aS(e,t,n){let r=uS(e,t,n),i=Q(`div`,{class:`messages`,id:iv(`fault`)}),a=Q(`span`,{class:`hint`,id:iv(`hint`)},cS(n)),o=Q(`label`,{class:n.needed?`label needed`:`label`},...sS(n));dS(r,o),r.focus.setAttribute(`aria-describedby`,`${a.id} ${i.id}`);let s=Q(`div`,{class:n.node.is===`places`||n.node.is===`factors`?`field tall`:`field`,"data-path":Dv(t),title:lS(n)},o,r.element,a,i);return{element:s,update:()=>{r.update(),Zx(e,t,s,r.focus,i)},reveal:e=>Qx(r,t,e,s)}}function oS(e,t,n,r){let i=uS(e,t,n);i.focus.setAttribute(`aria-label`,r);let a=Q(`div`,{class:`messages`,id:iv(`fault`)});i.focus.setAttribute(`aria-describedby`,a.id);let o=Q(`div`,{class:`cell`,"data-path":Dv(t)},i.element,a);return{element:o,update:()=>{i.update(),Zx(e,t,o,i.focus,a)},reveal:e=>Qx(i,t,e,o)}}function sS(e){let t=Fx(e),n=e.symbol&&e.symbol!==t&&!e.symbol.includes(`,`)?Px(e.symbol):null,r=t||(n?``:e.name);return[r,...r&&n?[` `]:[],...n?[n]:[]]}function cS(e){return Fx(e).toLowerCase()===e.hint.toLowerCase()?e.range:lS(e)}function lS(e){return e.range?`${e.hint} (${e.range})`:e.hint}function uS(e,t,n){return n.node.is===`places`?rS(e,t,n.node.each):n.node.is===`factors`?tS(e,t):Xx(e,t,n)}function dS(e,t){t.id=iv(`label`),e.focus.id===``&&(e.focus.id=iv(`input`)),e.element.matches(`input, select, .with-names`)?t.htmlFor=e.focus.id:(e.element.setAttribute(`role`,`group`),e.element.setAttribute(`aria-labelledby`,t.id))}function fS(e,t,n){let r=Q(`thead`,{}),i=Q(`tbody`,{}),a=Q(`table`,{class:`grid`},r,i),o=Q(`div`,{class:`grid-box`},a),s=[],c=[],l=``,u=()=>{c=n.fields.flatMap(n=>n.node.is===`factors`?hS(e,t,n):[pS(e,n)]),$(r,Q(`tr`,{},Q(`th`,{class:`number-of`,scope:`col`},`#`),...c.map(e=>e.head),Q(`th`,{class:`acts`}))),s=[],$(i)};return{element:o,update:()=>{let r=Ev(e.data(),t),o=n.fields.some(e=>e.node.is===`factors`)?mS(e,t).join(`
`):``;for((c.length===0||o!==l)&&(l=o,u()),a.hidden=r.length===0;s.length>r.length;)s.pop()?.element.remove();for(;s.length<r.length;){let r=gS(e,[...t,s.length],n,c);s.push(r),i.append(r.element)}for(let e of s)e.update()},reveal:e=>{let n=e[t.length],r=typeof n==`number`?s[n]:void 0;return r?r.cells.some(t=>t.reveal(e))?!0:(r.element.querySelector(`input, select`)?.focus(),Av(e,t)):!1}}}function pS(e,t){return{head:Q(`th`,{scope:`col`,title:lS(t),class:t.needed?`needed`:null},...sS(t)),cell:(n,r)=>oS(e,[...n,t.name],t,`${t.name} of item ${r}`)}}function mS(e,t){let n=Ev(e.data(),t).flatMap((n,r)=>Object.keys(Tv(e.data(),[...t,r,`factors`])));return[...new Set([...Jv(Ev(e.data(),[`cases`])),...n])]}function hS(e,t,n){return mS(e,t).map(t=>({head:Q(`th`,{scope:`col`,class:`factor`,title:`${n.hint}: ${t}`},t),cell:(r,i)=>eS(e,[...r,n.name],t,`factor of ${t} in item ${i}`)}))}function gS(e,t,n,r){let i=Number(t.at(-1))+1,a=r.map(e=>e.cell(t,i)),o=Q(`div`,{class:`messages`});return{element:Q(`tr`,{},Q(`td`,{class:`number-of`},String(i)),...a.map(e=>Q(`td`,{},e.element)),Q(`td`,{class:`acts`},...ES(e,t),o)),cells:a,update:()=>{for(let e of a)e.update();let r=hx(e.faults(),[...t,`factors`]).filter(e=>e.path.length===t.length+1),i=[...gx(e.faults(),t,n),...r].map(vx);$(o,...i.map(e=>Q(`p`,{},e)))}}}var _S=7,vS=new Set([`quantity`,`number`,`whole`,`choice`,`flag`,`text`,`tuple`,`factors`]);function yS(e,t,n,r,i,a=!1){let o=n.is===`kinds`?n.parts:n.is===`part`?[n.part]:[],s=o.map(t=>e.schema.part(t)),c=s.some(e=>e.kind),l=Q(`div`,{class:`messages`}),u=Q(`span`,{class:`count`}),d=Q(`div`,{}),f=c&&s.length>1?Q(`select`,{"aria-label":`kind of the new item of ${r}`}):null;f&&$(f,...s.map(e=>Q(`option`,{value:e.name},zS(e))));let p=!c&&s.length>1?CS(e,t,o):null,m=Q(`button`,{type:`button`,class:`small`,onclick:()=>v()},`Add${f?``:` ${bS(r)}`}`),h=Q(`div`,{class:`list`,"data-part":Dv(t)},Q(`div`,{class:`sub-head`},a?Q(`span`,{class:`hint`},i):Q(`h4`,{title:i},r,` `,u,Q(`span`,{class:`hint`},i))),p?.element,l,d,Q(`div`,{class:`list-foot`},f,m)),g=null,_=null,v=()=>{let n=f?s.find(e=>e.name===f.value):_??s[0];n&&e.change({edits:[{op:`add`,path:t,value:SS(e.data(),t,n)}],text:`add ${bS(r).toLowerCase()}`})};return{element:h,update:()=>{let r=Ev(e.data(),t),i=c?null:e.schema.partOf(n,Cv(r[0])?r[0]:{});g&&i===_||(_=i,g=_&&xS(_)?fS(e,t,_):wS(e,t,n),$(d,g.element)),u.textContent=r.length>0?String(r.length):``,p?.update(),g.update();let a=_x(e.faults(),t).map(vx);$(l,...a.map(e=>Q(`p`,{},e)))},reveal:e=>Av(e,t)?(g?.reveal(e)||m.focus(),!0):!1}}function bS(e){let t=e.charAt(0).toLowerCase()+e.slice(1);return t.endsWith(`s`)?t.slice(0,-1):t}function xS(e){return e.fields.length<=_S&&e.fields.every(e=>vS.has(e.node.is))}function SS(e,t,n){let r={...n.kind?{kind:n.kind}:{},...ky(n.name,e),...Ex(e,[...t,0],n)};if(n.fields.find(e=>e.name===`name`)?.needed||n.name.endsWith(`Support`)||n.name===`Borehole`){let i=n.name===`Column`?`C1`:n.name===`Borehole`?`B1`:`${String(t.at(-1)).replace(/s$/,``)} 1`;return{name:ex(Jv(Ev(e,t)),i),...r}}return r}function CS(e,t,n){let r=LS(e,[...t,0],n),i=r.element.querySelector(`select`);return i?.addEventListener(`change`,r=>{r.stopImmediatePropagation();let a=e.schema.part(i.value),o=Dv([...t,a.name]),s=Ev(e.data(),t),c=e.schema.chosen(n,Cv(s[0])?s[0]:{});c&&e.memory.set(Dv([...t,c.name]),{items:s});let l=e.memory.get(o)?.items,u=Array.isArray(l)&&l.length===s.length?l:s.map(()=>ky(a.name,e.data()));e.change({edits:[{op:`set`,path:t,value:u}],text:`give layers by ${zS(a)}`})},{capture:!0}),r}function wS(e,t,n){let r=Q(`div`,{class:`items`}),i=[];return{element:r,update:()=>{let a=Ev(e.data(),t).length;for(;i.length>a;)i.pop()?.element.remove();for(;i.length<a;){let a=TS(e,[...t,i.length],n);i.push(a),r.append(a.element)}for(let e of i)e.update()},reveal:e=>{let n=e[t.length];return(typeof n==`number`?i[n]:void 0)?.reveal(e)??!1}}}function TS(e,t,n){let r=Q(`span`,{class:`item-title`}),i=Q(`span`,{class:`badge`}),a=Q(`summary`,{},r,i,...ES(e,t)),o=Q(`details`,{class:`item`,"data-item":Dv(t)},a),s=null,c=()=>{o.open&&!s&&(s=IS(e,t,n),o.append(s.element),s.update())};return o.addEventListener(`toggle`,c),{element:o,update:()=>{let a=Tv(e.data(),t);r.textContent=zx(a,e.schema.partOf(n,a))||my(e.data(),t);let o=hx(e.faults(),t).length;i.textContent=o>0?String(o):``,i.title=o>0?`${o} faults`:``,s?.update()},reveal:e=>(o.open=!0,c(),s?.reveal(e)??!1)}}function ES(e,t){let n=e=>t=>{t.preventDefault(),t.stopPropagation(),e()},r=Number(t.at(-1)),i=n(()=>{let n=t.slice(0,-1),i=structuredClone(Tv(e.data(),t));typeof i.name==`string`&&i.name&&(i.name=ex(Jv(Ev(e.data(),n)),i.name)),e.change({edits:[{op:`add`,path:n,value:i,at:r+1}],text:`duplicate ${my(e.data(),t)}`})}),a=n(()=>e.change(Ey(e.data(),t)));return[Q(`button`,{type:`button`,class:`icon`,title:`duplicate`,"aria-label":`duplicate item ${r+1}`,onclick:i},tv(`copy`)),Q(`button`,{type:`button`,class:`icon`,title:`remove`,"aria-label":`remove item ${r+1}`,onclick:a},tv(`remove`))]}var DS=[`length_x`,`length_y`,`outline`],OS=`sides`,kS=[`Rectangle`,`Polygon`,`Circle`],AS=[`plate`,`outline`];function jS(e){let t=Q(`select`,{id:iv(`input`)});$(t,Q(`option`,{value:OS},`rectangle about the origin`),...kS.map(e=>Q(`option`,{value:e},e===`Rectangle`?`rectangle anywhere`:e.toLowerCase())));let n=e.schema.part(`Plate`).fields.filter(e=>e.name===`length_x`||e.name===`length_y`).map(t=>aS(e,[`plate`,t.name],t)),r=Q(`div`,{class:`plate-shape`},Q(`div`,{class:`field`,"data-path":Dv(AS)},Q(`label`,{class:`label needed`,for:t.id},`outline`),t),...n.map(e=>e.element));return t.addEventListener(`change`,()=>{let n=t.value===OS?PS(e.data()):NS(e,t.value);e.change({edits:n,text:`change the slab's outline to ${t.value===OS?`a rectangle about the origin`:`a ${t.value.toLowerCase()}`}`})}),{element:r,update:()=>{let r=Tv(e.data(),[`plate`]),i=r.outline===void 0?null:e.schema.chosen(kS,Tv(e.data(),AS));t.value=r.outline===void 0?OS:i?.name??``,n.forEach((e,t)=>e.element.hidden=r.outline!==void 0&&r[t===0?`length_x`:`length_y`]===void 0);for(let e of n)e.update()},reveal:e=>n.some(t=>t.reveal(e))}}function MS(e){let t=IS(e,AS,{is:`kinds`,parts:kS});return t.element.classList.add(`without-kind`),{element:t.element,update:()=>{t.element.hidden=Tv(e.data(),[`plate`]).outline===void 0,t.update()},reveal:e=>Av(e,AS)&&t.reveal(e)}}function NS(e,t){let n=e.data(),r=Tv(n,[`plate`,`outline`]);return Jb(n,Ex(n,[`plate`,`outline`],e.schema.part(t),r))}function PS(e){let t=Ex(e,[`plate`,`outline`],{name:`Rectangle`,about:``,kind:`rectangle`,fields:[]},Tv(e,[`plate`,`outline`])),n=Xv(e),r=e=>{let[n,r]=t[e].map(e=>parseFloat(e));return zv((r??3)-(n??-3))},i=n?Qv(n):null,[a,o]=i?[zv(2*Math.abs(i[0]?.[0]??3)),zv(2*Math.abs(i[0]?.[1]??2))]:[r(`x`),r(`y`)];return[{op:`remove`,path:[`plate`,`outline`]},{op:`set`,path:[`plate`,`length_x`],value:a},{op:`set`,path:[`plate`,`length_y`],value:o}]}function FS(e,t,n){let{node:r}=n;return r.is===`list`?yS(e,t,r.of,Ix(Fx(n)||n.name),n.hint):r.is===`part`||r.is===`kinds`?VS(e,t,n,r):aS(e,t,n)}function IS(e,t,n,r=[]){let i=Q(`div`,{class:`fields`}),a=Q(`div`,{class:`messages`,id:iv(`fault`)}),o=n.is===`kinds`?LS(e,t,n.parts):null,s=Q(`div`,{class:`part`,"data-part":Dv(t)},o?.element,a,i),c=null,l=[],u=!1,d=()=>{u=!0;let n=c?.name===`Plate`?[...r,...DS]:r,a=c?.fields.filter(e=>e.node.is!==`tag`&&!n.includes(e.name))??[];a.sort((e,t)=>Number(RS(e))-Number(RS(t))),l=a.map(n=>FS(e,[...t,n.name],n)),c?.name===`Plate`&&(l.unshift(jS(e)),l.splice(1+a.filter(e=>!RS(e)).length,0,MS(e))),$(i,...l.map(e=>e.element))};return{element:s,update:()=>{let r=e.schema.partOf(n,Tv(e.data(),t));u&&r===c||(c=r,d()),o?.update();for(let e of l)e.update();let i=gx(e.faults(),t,c).filter(e=>e.path[t.length]!==`kind`||!o).map(vx);a.textContent!==i.join(``)&&$(a,...i.map(e=>Q(`p`,{},e)))},reveal:e=>Av(e,t)?(o?.reveal(e)||l.some(t=>t.reveal(e))||(s.scrollIntoView({block:`nearest`}),s.querySelector(`input, select, button`)?.focus()),!0):!1}}function LS(e,t,n){let r=n.map(t=>e.schema.part(t)),i=r.some(e=>e.kind),a=Q(`select`,{id:iv(`input`)}),o=Q(`div`,{class:`messages`,id:iv(`fault`)}),s=Q(`span`,{class:`hint`});a.setAttribute(`aria-describedby`,o.id);let c=Q(`label`,{class:`label needed`,for:a.id},i?`kind`:`given by`),l=Q(`div`,{class:`field kind`,"data-path":Dv([...t,`kind`])},c,a,s,o);return a.addEventListener(`change`,()=>{let i=r.find(e=>e.name===a.value),o=e.schema.chosen(n,Tv(e.data(),t));if(!i||i===o)return;let s=bx(e.data(),t,o,i,e.memory);s.length>0&&e.change({edits:s,text:`change ${my(e.data(),t)} to ${zS(i)}`})}),{element:l,update:()=>{let i=Tv(e.data(),t),c=e.schema.chosen(n,i),u=c?[]:[Q(`option`,{value:``},typeof i.kind==`string`?i.kind:`choose …`)];$(a,...u,...r.map(e=>Q(`option`,{value:e.name},zS(e)))),a.value=c?.name??``,s.textContent=c?BS(c):``;let d=e.faults().filter(e=>Av(e.path,[...t,`kind`]));l.classList.toggle(`faulty`,d.length>0),$(o,...d.map(e=>Q(`p`,{},vx(e))))},reveal:e=>Av(e,[...t,`kind`])?(l.scrollIntoView({block:`nearest`}),a.focus(),!0):!1}}function RS(e){return[`list`,`part`,`kinds`,`places`].includes(e.node.is)}function zS(e){return e.kind?e.kind:e.fields.filter(e=>e.needed).map(e=>e.name).join(`, `)}function BS(e){return e.fields.find(e=>e.node.is===`tag`)?.hint??e.about}function VS(e,t,n,r,i=!1){let a=IS(e,t,r),o=r.is===`kinds`?r.parts[0]:r.is===`part`?r.part:void 0,s=o===void 0?null:e.schema.part(o),c=!n.needed&&(r.is===`kinds`||s?.fields.some(e=>e.needed)===!0),l=Q(`button`,{type:`button`,class:`small`},`Add ${Fx(n)||n.name}`),u=Q(`button`,{type:`button`,class:`small quiet`},`Remove`),d=Q(`h4`,{title:n.hint},Ix(Fx(n)||n.name),Q(`span`,{class:`hint`},n.hint)),f=Q(`div`,{class:`sub-part`},i&&!c?null:Q(`div`,{class:`sub-head`},i?Q(`span`,{class:`hint`},n.hint):d,c?u:null,c?l:null),a.element),p=Fx(n)||n.name;return l.addEventListener(`click`,()=>{if(!s)return;let n={...s.kind?{kind:s.kind}:{},...ky(s.name,e.data()),...Ex(e.data(),t,s)};e.change({edits:[{op:`set`,path:t,value:n}],text:`add ${p}`})}),u.addEventListener(`click`,()=>e.change({edits:[{op:`remove`,path:t}],text:`remove ${p}`})),{element:f,update:()=>{let n=!c||wv(e.data(),t)!==void 0;a.element.hidden=!n,u.hidden=!n,l.hidden=n,a.update()},reveal:a.reveal}}var HS=[`openings`,`zones`,`edges`];function US(e,t){let n=Q(`h3`,{}),r=Q(`div`,{class:`property-acts`}),i=Q(`div`,{class:`property-body`}),a=Q(`section`,{class:`properties`,"aria-label":`properties`},Q(`div`,{class:`property-head`},n,r),i),o=``,s=null,c=(e,t,n)=>Q(`button`,{type:`button`,class:`small`,title:n,onclick:t},e),l=t=>{let c=t===null||t[0]===`plate`&&t.length<3,l=c?[`plate`]:t,f=e.schema.nodeAt(l,e.data()),m=Dv(l);if(f===null||!c&&wv(e.data(),l)===void 0)o=``,s=null,$(n),$(r),$(i,Q(`p`,{class:`empty`},`Nothing is selected.`));else{if(m===o)return p();o=m,s=IS(e,l,f.node,c?HS:[]),$(i,s.element),$(r,...c?u():d(l)),p(),a.scrollTop=0}},u=()=>[c(`Change into polygon`,()=>t.push({edits:NS(e,`Polygon`),text:`change the slab into a polygon`}),`Draw the outline by its corners, so that they can be moved one by one`)],d=n=>[c(`Duplicate`,()=>{let r=t.step(),i=tx(e.data(),n,my(e.data(),n),f(n)?[r,r]:[0,0]);i&&(t.push(i.change),t.select(i.path))},`Make a copy beside it (Ctrl+D)`),c(`Remove`,()=>{t.push(Ey(e.data(),n)),t.select(null)},`Remove it (Delete)`)],f=t=>typeof wv(e.data(),[...t,`column`])!=`string`,p=()=>{if(!s)return;let t=JSON.parse(o),i=t.length===1;n.textContent=i?`Slab`:my(e.data(),t);let a=wv(e.data(),[`plate`,`outline`])===void 0;if(i)for(let t of r.children)t instanceof HTMLElement&&(t.hidden=!a&&wv(e.data(),[`plate`,`outline`,`kind`])===`polygon`);s.update()};return{element:a,show:l,update:p,reveal:e=>s?.reveal(e)??!1}}var WS={select:`M4 2l8 7-4 .6L10.3 14l-1.8.8-2.2-4.3L4 13z`,slab:`M2 4h12v8H2z`,opening:`M2 3h12v10H2zM5.5 6h5v4h-5zM5.5 6l5 4M10.5 6l-5 4`,zone:`M2 4h12v8H2zM7 4v8M9 12l5-5M7 11l7-7M7 7.5L10.5 4`,column:`M5 5h6v6H5zM5 5l6 6M11 5l-6 6`,"point load":`M8 2v10M5 9l3 4 3-4M3 14.5h10`,"line load":`M2 3h12M3 3v8M8 3v8M13 3v8M2 13h12M1.8 9L3 11.5 4.2 9M6.8 9L8 11.5 9.2 9M11.8 9l1.2 2.5L14.2 9`,"area load":`M2 5l3-2h9l-3 2zM2 5v7l9 .0V5M11 12l3-2V3M4.5 7v3M8 7v3`,support:`M8 3l5 8H3zM2 13.5h12`,wall:`M2 5h12M3 9l3-4M7 9l3-4M11 9l3-4`,borehole:`M8 2a6 6 0 1 0 .01 0M8 2v12M2 8h12`,"soil zone":`M2 4h12v8H2zM4 7h2M8 6h2M11 9h2M5 10h2`,void:`M2 5h3c0 7 6 7 6 0h3M2 13h12`,"section line":`M2 12L14 4M1 10.5l2.2 3M12.8 2.5l2.2 3`};function GS(e){return Z_(`svg`,{viewBox:`0 0 16 16`,width:16,height:16,class:`icon-line`,"aria-hidden":`true`},Z_(`path`,{d:WS[e]}))}var KS=[[`select`],[`slab`,`opening`,`zone`,`column`],[`point load`,`line load`,`area load`],[`support`,`wall`],[`borehole`,`soil zone`,`void`],[`section line`]];function qS(e){let t=new Map,n=Ub(`select`),r=r=>{n=Ub(r);for(let[e,n]of t)n.setAttribute(`aria-pressed`,String(e===r)),n.tabIndex=e===r?0:-1;e(n)},i=e=>{let i=Q(`button`,{type:`button`,class:`tool`,title:`${e.label} (${e.key}). ${e.hint}`,"aria-pressed":e.name===`select`,"aria-keyshortcuts":e.key,"data-tool":e.name,onclick:()=>r(e.name)},GS(e.name),Q(`span`,{},e.label),Q(`kbd`,{},e.key));return i.setAttribute(`aria-pressed`,String(e.name===n.name)),i.tabIndex=e.name===n.name?0:-1,t.set(e.name,i),i},a=Q(`div`,{class:`tools`,role:`toolbar`,"aria-label":`drawing tools`,"aria-orientation":`vertical`},...KS.map(e=>Q(`div`,{class:`tool-group`},...e.map(e=>i(Ub(e))))));return a.addEventListener(`keydown`,e=>{let n=e.key===`ArrowDown`?1:e.key===`ArrowUp`?-1:0;if(n===0)return;e.preventDefault();let r=[...t.values()];r[(r.findIndex(e=>e===document.activeElement)+n+r.length)%r.length]?.focus()}),{element:a,current:()=>n,choose:r}}function JS(e){return Hb.find(t=>t.key.toLowerCase()===e.toLowerCase())?.name??null}function YS(){let e=Q(`p`,{class:`drawing-hint`,role:`status`});return{element:e,say:t=>nv(e,t)}}function XS(e,t,n){let r=new Lb(e),i=YS(),a=US(t,{push:n,select:t=>e.select(t),step:()=>r.step}),o=qS(e=>{s.cancel(),i.say(e.hint),r.element.dataset.tool=e.draws,r.element.focus({preventScroll:!0})}),s=new dx(r,e,{push:n,select:t=>e.select(t),tool:()=>o.current(),drawn:(t,r)=>{n(t),e.select(r),o.current().draws!==`point`&&o.choose(`select`)},editable:()=>!e.broken,say:e=>i.say(e)}),c=new mx(r,n),l=Q(`div`,{class:`drawing-box`},r.element),u=ZS(e,e=>{r.loadCase=e,r.paint()}),d=Q(`div`,{class:`everywhere`}),f=Q(`button`,{type:`button`,class:`small`,title:`Show everything (0)`,onclick:()=>r.fit()},`Fit`),p=Q(`div`,{class:`drawing-corner`},u.element,f),m=Q(`p`,{class:`drawing-empty`},`Draw the slab: choose Slab (B), then drag a rectangle or click corner after corner.`);l.append(p,m);let h=Q(`div`,{class:`plan-editor`},o.element,Q(`div`,{class:`plan-middle`},l,d,i.element),a.element);i.say(o.current().hint);let g=new eC(r,s,c,e,n,e=>o.choose(e),()=>o.current().name);return r.element.addEventListener(`keydown`,e=>{g.down(e)&&e.preventDefault()}),new ResizeObserver(()=>r.resize(l.clientWidth,l.clientHeight)).observe(l),e.on([`data`],()=>{r.refresh(),e.selection&&wv(e.data,e.selection)===void 0&&e.select(null),u.update(),m.hidden=r.items.some(e=>e.kind===`slab`),QS(d,e,n),a.show(e.selection)}),e.on([`doc`],()=>{r.paint(),a.update()}),e.on([`selection`],()=>{if(r.corner=null,r.paint(),a.show(e.selection),QS(d,e,n),e.selection){let e=r.selected;e&&i.say(`${e.title} is selected. ${e.movable?`Drag it, or move it with the arrow keys; Delete removes it.`:px(e)}`)}else i.say(o.current().hint)}),{element:h,reveal:t=>{let n=r.items.findLast(e=>e.kind!==`slab`&&e.path.every((e,n)=>e===t[n]));if(n)e.select(n.path);else if(t[0]===`plate`)e.select(null);else return!1;return a.reveal(t)},fit:()=>r.fit()}}function ZS(e,t){let n=Q(`select`,{"aria-label":`load case shown`,title:`Loads of this case are drawn strongly, and new loads belong to it`});return n.addEventListener(`change`,()=>t(n.value)),{element:n,update:()=>{let r=Jv(Ev(e.data,[`cases`])),i=n.value;$(n,Q(`option`,{value:``},`all load cases`),...r.map(e=>Q(`option`,{value:e},e))),n.value=r.includes(i)?i:``,n.hidden=r.length===0,n.value!==i&&t(n.value)}}}function QS(e,t,n){let r=Ev(t.data,[`loads`]).flatMap((e,n)=>{let r=typeof e==`object`&&e&&!Array.isArray(e)?e:{};if(!ly.has(String(r.kind)))return[];let i=String(r.q??r.unit_weight??r.difference??r.w??``),a=r.name?String(r.name):String(r.kind),o=[`loads`,n],s=`${a} ${i}${r.case?` (${String(r.case)})`:``}`;return[Q(`button`,{type:`button`,class:`chip`,"aria-pressed":kv(o,t.selection)?`true`:`false`,title:`Load on the whole slab`,onclick:()=>t.select(o)},s)]}),i=Q(`span`,{class:`chips`},...r.length>0?r:[Q(`span`,{class:`quiet`},`no loads`)]);$(e,Q(`span`,{},`Whole slab:`),i,$S(t,n))}function $S(e,t){let n=(n,r)=>Q(`button`,{type:`button`,class:`chip add`,disabled:e.broken,title:`Add ${r}`,onclick:()=>{let i=Jv(Ev(e.data,[`cases`]))[0],a=[`loads`,Ev(e.data,[`loads`]).length];t({edits:[{op:`add`,path:[`loads`],value:{...ky(n,e.data),...i?{case:i}:{}}}],text:`add ${r}`}),e.select(a)}},`+ ${r}`);return Q(`span`,{class:`chip-adds`},n(`UniformLoad`,`uniform load`),n(`SelfWeight`,`own weight`))}var eC=class{canvas;pointer;nudge;store;push;choose;tool;constructor(e,t,n,r,i,a,o){this.canvas=e,this.pointer=t,this.nudge=n,this.store=r,this.push=i,this.choose=a,this.tool=o}down(e){let{canvas:t}=this;if((e.ctrlKey||e.metaKey)&&e.key.toLowerCase()===`d`)return this.duplicate();if(e.ctrlKey||e.metaKey||e.altKey)return!1;switch(e.key){case`Escape`:return!this.pointer.cancel()&&this.tool()===`select`&&this.store.select(null),this.choose(`select`),!0;case`Enter`:return this.pointer.finish(),!0;case`Delete`:case`Backspace`:return this.remove();case`0`:return t.fit(),!0;case`+`:case`=`:case`-`:return t.camera.zoom(e.key===`-`?.8:1.25),t.moved(),!0;case`n`:case`N`:return this.next(e.shiftKey?-1:1);case` `:return!0}let n=tC[e.key];if(n)return this.arrow(n,e.shiftKey?10:1);let r=JS(e.key);return r?(this.choose(r),!0):!1}arrow([e,t],n){let r=this.canvas.selected;if(r?.movable&&!this.store.broken){let i=this.canvas.step*n;this.nudge.step(r,e*i,t*i)}else this.canvas.camera.pan(-e*40,t*40),this.canvas.moved();return!0}remove(){let{selected:e,corner:t}=this.canvas;if(this.store.broken)return!0;if(e&&t!==null){let n=Wy(e.geometry,t);if(n)return this.canvas.corner=null,this.push({edits:sy(e.geometry,n),text:`remove a corner of ${e.title}`}),!0}let n=this.store.selection;return!n||n[0]===`plate`&&n.length<3||(this.push(Ey(this.store.data,n)),this.store.select(null)),!0}duplicate(){let e=this.canvas.selected;if(!e||this.store.broken)return!0;let t=this.canvas.step*2,n=tx(this.store.data,e.path,e.title,e.movable?[t,t]:[0,0]);return n&&(this.push(n.change),this.store.select(n.path)),!0}next(e){let{items:t}=this.canvas,n=t[(t.findIndex(e=>kv(e.path,this.store.selection))+e+t.length)%Math.max(1,t.length)];return this.store.select(n?.path??null),!0}},tC={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]},nC=[{title:``,keys:[`title`]},{title:`Slab`,keys:[`plate`,`columns`,`supports`]},{title:`Ground`,keys:[`ground`,`soil_zones`,`boreholes`,`beyond`,`contact`]},{title:`Loads`,keys:[`cases`,`loads`,`combinations`,`combine`]},{title:`Results`,keys:[`output`,`reinforcement`]},{title:`Analysis`,keys:[`mesh`,`analysis`]}],rC={plate:`Slab`,cases:`Load cases`,combine:`Combinations by EN 1990`,beyond:`Ground beyond the slab`,output:`Points, lines and strips`},iC=[`plate`,`ground`];function aC(e,t){let n=e.schema.part(``),r=new Set(nC.flatMap(e=>e.keys)),i=n.fields.filter(e=>!r.has(e.name)).map(e=>e.name),a=Q(`div`,{class:`messages`}),o=Q(`div`,{class:`form`,role:`region`,"aria-label":`form`},a),s=new Set(t.read()??iC),c=[],l=(e,n)=>{n?s.add(e):s.delete(e),t.write([...s])};for(let t of[...nC,{title:`More`,keys:i}]){let r=t.keys.flatMap(e=>n.fields.find(t=>t.name===e)??[]);r.length>0&&t.title&&o.append(Q(`h3`,{class:`group-title`},t.title));for(let t of r){let n=oC(t)?FS(e,[t.name],t):sC(e,t,s.has(t.name),l);c.push(n),o.append(n.element)}}return{element:o,update:()=>{for(let e of c)e.update();let t=gx(e.faults(),[],n).map(vx);$(a,...t.map(e=>Q(`p`,{},e)))},reveal:e=>c.some(t=>t.reveal(e))}}function oC(e){return![`part`,`kinds`,`list`].includes(e.node.is)}function sC(e,t,n,r){let i=[t.name],a=Q(`span`,{class:`digest`}),o=Q(`span`,{class:`badge`}),s=Q(`details`,{class:`section`,"data-section":t.name},Q(`summary`,{},Q(`span`,{class:`section-title`},rC[t.name]??Ix(t.name)),a,o)),c=null,l=()=>{s.open&&!c&&(c=cC(e,i,t),s.append(Q(`div`,{class:`section-body`},c.element)),c.update())};return s.open=n,s.addEventListener(`toggle`,()=>{l(),r(t.name,s.open)}),{element:s,update:()=>{nv(a,dC(t,e.data(),uC(e,t)));let n=hx(e.faults(),i).length;nv(o,n>0?String(n):``),o.title=lC(n),l(),s.open&&c?.update()},reveal:e=>e[0]===t.name&&(s.open=!0,l(),c?.reveal(e)??!1)}}function cC(e,t,n){let{node:r}=n;return r.is===`part`||r.is===`kinds`?VS(e,t,n,r,!0):r.is===`list`?yS(e,t,r.of,rC[n.name]??Ix(n.name),n.hint,!0):FS(e,t,n)}function lC(e){return e===0?``:e===1?`1 fault`:`${e} faults`}function uC(e,t){return!t.needed&&t.node.is===`part`&&e.schema.part(t.node.part).fields.some(e=>e.needed)}function dC(e,t,n){let r=t[e.name];if(e.node.is===`list`&&r===void 0)return`none`;if(Array.isArray(r))return r.length>0?String(r.length):`none`;if(!Cv(r))return e.needed?`missing`:n?`not used`:`by default`;if(e.name===`plate`)return[Cv(r.outline)?String(r.outline.kind??`outline`):[r.length_x,r.length_y].map(Lx).join(` × `),`t = ${Lx(r.thickness)}`].filter(Boolean).join(`, `);if(e.name===`output`)return Object.entries(r).map(([e,t])=>`${Array.isArray(t)?t.length:0} ${e}`).join(`, `);let i=Array.isArray(r.layers)?`${r.layers.length} layer${r.layers.length===1?``:`s`}`:``,a=Object.entries(r).filter(([e,t])=>e!==`kind`&&!Cv(t)&&!(Array.isArray(t)&&Cv(t[0]))).slice(0,3).map(([e,t])=>`${e.replaceAll(`_`,` `)} ${Lx(t)}`);return[typeof r.kind==`string`?r.kind:``,i,...a].filter(Boolean).join(`, `)||`by default`}function fC(e){return`${e.where}: got ${e.got}, expected ${e.expected}${e.mend?` — ${e.mend}`:``}`}function pC(e,t){let n=Q(`span`,{class:`fault-count`}),r=Q(`ul`,{}),i=Q(`span`,{class:`first-fault`}),a=Q(`details`,{class:`fault-list`},Q(`summary`,{},n,i),r);return a.addEventListener(`click`,t=>{e.doc?.faults.length===0&&t.target instanceof Node&&!r.contains(t.target)&&t.preventDefault()}),e.on([`doc`],()=>{let o=e.doc?.faults??[];a.classList.toggle(`bad`,o.length>0),n.textContent=e.doc?.checking?`Being checked …`:o.length===0?`No faults`:o.length===1?`1 fault`:`${o.length} faults`,i.textContent=o[0]?fC(o[0]):``,o.length===0&&(a.open=!1),$(r,...o.map(e=>Q(`li`,{},Q(`button`,{type:`button`,onclick:()=>t(e)},fC(e)))))}),{element:a,open:()=>a.open=!0}}var mC=class{root;parts=new Map;constructor(e){this.root=e}part(e){let t=this.parts.get(e);if(t)return t;let n=Cv(this.root.definitions)?this.root.definitions:{},r=e===``?this.root:n[e],i=hC(e,Cv(r)?r:{});return this.parts.set(e,i),i}chosen(e,t){let n=e.map(e=>this.part(e));if(n.some(e=>e.kind))return n.find(e=>e.kind===t.kind)??null;let r=e=>e.fields.filter(e=>e.name in t).length;return n.reduce((e,t)=>e&&r(e)>=r(t)?e:t,null)}nodeAt(e,t){let n={is:`part`,part:``},r=null,i=t;for(let t of e)if(typeof t==`number`){if(n.is===`list`)n=n.of;else if(n.is===`tuple`||n.is===`values`||n.is===`places`)n=n.each;else return null;i=Array.isArray(i)?i[t]:void 0}else{if(r=this.partOf(n,Cv(i)?i:{})?.fields.find(e=>e.name===t)??null,!r)return null;n=r.node,i=Cv(i)?i[t]:void 0}return{node:n,field:r}}partOf(e,t){return e.is===`part`?this.part(e.part):e.is===`kinds`?this.chosen(e.parts,t):null}};function hC(e,t){let n=Cv(t.properties)?t.properties:{},r=Array.isArray(t.required)?t.required:[],i=Object.entries(n).flatMap(([e,t])=>Cv(t)?[gC(e,t,r.includes(e))]:[]),a=i.find(e=>e.node.is===`tag`);return{name:e,about:_C(t.description),kind:a?.node.is===`tag`?a.node.word:``,fields:i}}function gC(e,t,n){let r=_C(t[`x-symbol`]),i=_C(t.description),a=r&&i.startsWith(`${r}: `)?i.slice(r.length+2):i,o=Cv(t.items)?t.items:{},s=_C(t[`x-range`])||_C(o[`x-range`])||CC(t);return{name:e,node:bC(t),symbol:r,hint:a,range:s,needed:n,default:t.default}}function _C(e){return typeof e==`string`?e:``}function vC(e){return Array.isArray(e)?e.filter(e=>typeof e==`string`):[]}function yC(e){let t=Cv(e)?_C(e.$ref):``;return t.startsWith(`#/definitions/`)?t.slice(14):null}function bC(e){let t=yC(e)??(Array.isArray(e.allOf)?yC(e.allOf[0]):null);if(t!==null)return{is:`part`,part:t};if(Array.isArray(e.oneOf))return{is:`kinds`,parts:e.oneOf.flatMap(e=>yC(e)??[])};if(typeof e.const==`string`)return{is:`tag`,word:e.const};if(Array.isArray(e.enum))return{is:`choice`,words:vC(e.enum)};if(Array.isArray(e.anyOf))return{is:`number`,words:e.anyOf.flatMap(e=>Cv(e)?vC(e.enum):[])};switch(e.type){case`array`:return xC(e);case`object`:return{is:`factors`};case`boolean`:return{is:`flag`};case`integer`:return{is:`whole`};case`number`:return{is:`number`,words:[]};default:return typeof e[`x-dimension`]==`string`?{is:`quantity`,dimension:e[`x-dimension`],example:vC(e.examples)[0]??``}:{is:`text`}}}function xC(e){let t=Cv(e.items)?bC(e.items):{is:`text`};if(t.is===`part`||t.is===`kinds`)return{is:`list`,of:t,least:SC(e.minItems)??0};if(t.is===`choice`&&e.uniqueItems===!0)return{is:`several`,words:t.words};let n=SC(e.maxItems);return n!==null&&n===SC(e.minItems)?{is:`tuple`,each:t,length:n}:t.is===`tuple`?{is:`places`,each:t}:{is:`values`,each:t}}function SC(e){return typeof e==`number`?e:null}function CC(e){return[[`exclusiveMinimum`,`>`],[`minimum`,`≥`],[`exclusiveMaximum`,`<`],[`maximum`,`≤`]].flatMap(([t,n])=>{let r=SC(e[t]);return r===null||r===2147483647?[]:[`${n} ${r}`]}).join(`, `)}var wC=`groundslab-token`,TC=`groundslab-sections`;function EC(){let e=new URL(location.href),t=e.searchParams.get(`token`);return t===null?sessionStorage.getItem(wC)??``:(sessionStorage.setItem(wC,t),e.searchParams.delete(`token`),history.replaceState(null,``,e),new BroadcastChannel(wC).postMessage(t),t)}function DC(e){new BroadcastChannel(wC).addEventListener(`message`,t=>{typeof t.data==`string`&&(sessionStorage.setItem(wC,t.data),e(t.data))})}var OC={read(){let e=kC(TC);return e===null?null:e.split(` `).filter(Boolean)},write(e){AC(TC,e.join(` `))}};function kC(e){try{return localStorage.getItem(e)}catch{return null}}function AC(e,t){try{localStorage.setItem(e,t)}catch{}}var jC=.02;function MC(e,t,n,r,i,a){let o=`groundslab${t}`,s=Q(`div`,{class:`splitter ${n}`,role:`separator`,tabindex:0,"aria-label":a,"aria-orientation":n===`x`?`vertical`:`horizontal`}),c=NC(o)??r,l=n=>{c=Math.min(i[1],Math.max(i[0],n)),e.style.setProperty(t,`${(c*100).toFixed(2)}%`),s.setAttribute(`aria-valuenow`,String(Math.round(c*100))),PC(o,c)};return s.addEventListener(`pointerdown`,e=>{s.setPointerCapture(e.pointerId),e.preventDefault()}),s.addEventListener(`pointermove`,t=>{if(!s.hasPointerCapture(t.pointerId))return;let r=e.getBoundingClientRect();l(n===`x`?(t.clientX-r.left)/r.width:(t.clientY-r.top)/r.height)}),s.addEventListener(`keydown`,e=>{let t=n===`x`?`ArrowLeft`:`ArrowUp`,r=n===`x`?`ArrowRight`:`ArrowDown`;(e.key===t||e.key===r)&&(e.preventDefault(),l(c+(e.key===r?jC:-.02)))}),s.addEventListener(`dblclick`,()=>l(r)),l(c),s}function NC(e){try{let t=Number(localStorage.getItem(e)??`x`);return Number.isFinite(t)&&t>0?t:null}catch{return null}}function PC(e,t){try{localStorage.setItem(e,String(t))}catch{}}function FC(e,t,n=()=>void 0){let r=e[0]?.name??``,i=e.map(e=>{e.panel.id||=iv(`panel`),e.panel.setAttribute(`role`,`tabpanel`),e.scrolls&&(e.panel.tabIndex=0);let t=Q(`button`,{type:`button`,role:`tab`,"aria-controls":e.panel.id,id:iv(`tab`),onclick:()=>a(e.name)},e.label,Q(`span`,{class:`badge`}));return e.panel.setAttribute(`aria-labelledby`,t.id),t}),a=t=>{r=t,e.forEach((e,n)=>{let r=e.name===t;e.panel.hidden=!r,i[n]?.setAttribute(`aria-selected`,String(r)),i[n]?.setAttribute(`tabindex`,r?`0`:`-1`)}),n(t)},o=Q(`div`,{class:`tabs`,role:`tablist`,"aria-label":t},...i);return o.addEventListener(`keydown`,t=>{let n=t.key===`ArrowRight`?1:t.key===`ArrowLeft`?-1:0;if(n===0)return;let o=(e.findIndex(e=>e.name===r)+n+e.length)%e.length;a(e[o]?.name??r),i[o]?.focus()}),a(r),{bar:o,current:()=>r,show:a,mark:(t,n,r=!1)=>{let a=i[e.findIndex(e=>e.name===t)]?.querySelector(`.badge`);a&&(a.textContent=n,a.classList.toggle(`bad`,r))}}}var IC=class{hooks;element;bar;plan;scene=null;locator=null;choice=0;field=``;fields=Q(`select`,{"aria-label":`field`,class:`field-choice`});combinations=Q(`select`,{"aria-label":`combination`,class:`combination-choice`});planBox=Q(`div`,{class:`stage-box`});spaceBox=Q(`div`,{class:`stage-box`,hidden:!0});reading=Q(`div`,{class:`reading`,"aria-hidden":`true`});legend;toolButtons;modeButtons;space=null;mode=`plan`;wantedName=``;constructor(e){this.hooks=e;let t=(e,t,n)=>Q(`button`,{type:`button`,title:t,onclick:n},e);this.toolButtons={pan:t(`Pan`,`Drag to shift the picture, turn the wheel to zoom`,()=>this.setTool(`pan`)),pick:t(`Pick`,`Click on the slab to read all values there`,()=>this.setTool(`pick`)),section:t(`Section`,`Click two places to draw the values along the line between them`,()=>this.setTool(`section`))},this.modeButtons={plan:t(`Plan`,`The slab from above`,()=>this.setMode(`plan`)),space:t(`3-D`,`The bent slab in space`,()=>this.setMode(`space`))};let n=Q(`div`,{class:`stage-side`});this.bar=Q(`div`,{class:`stage-bar`,role:`toolbar`,"aria-label":`result`},this.combinations,this.fields,Q(`div`,{class:`group`,role:`group`,"aria-label":`tool`},...Object.values(this.toolButtons)),Q(`div`,{class:`group`,role:`group`,"aria-label":`view`},...Object.values(this.modeButtons)),t(`Fit`,`Show the whole slab`,()=>this.fit())),this.element=Q(`div`,{class:`stage`},Q(`div`,{class:`stage-views`},this.planBox,this.spaceBox,this.reading),n),this.plan=new Ed(this.planBox),this.legend=new j_(n),this.plan.onShow=e=>this.legend.show(e,this.scene),this.plan.onPick=(t,n)=>e.picked([t,n]),this.plan.onSection=(t,n)=>e.cut(t,n),this.plan.onHover=e=>this.read(e),this.fields.addEventListener(`change`,()=>this.show(this.choice,this.fields.value)),this.combinations.addEventListener(`change`,()=>this.show(S(this.combinations.value),this.field)),gd(e=>{this.plan.setTheme(e),this.space?.setTheme(e)}),this.setTool(`pick`),this.setMode(`plan`)}take(e){this.scene=e,this.locator=new le(e.mesh),this.plan.setScene(e),this.space?.setScene(e),this.field=R_(this.fields,e,this.field||`settlement`);let t=e.head.combinations.findIndex(e=>e.name===this.wantedName),n=v(this.choice)?this.choice:t>=0?t:void 0,r=z_(this.combinations,e,n);for(let e of this.combinations.options)e.disabled=!1;this.show(t>=0&&n===t?t:r??0,this.field)}clear(){this.scene=null,this.locator=null,this.plan.setScene(null),this.plan.setPlan(null),this.plan.markPick(null),this.plan.markSection(null),this.space?.setScene(null),this.wantedName=``}show(e,t){let{scene:n}=this;if(!n)return;typeof e==`number`&&(this.wantedName=n.head.combinations[e]?.name??``),this.choice=e,this.field=t,this.combinations.value=String(e),this.fields.value=t,this.fields.title=p(n,t).meaning,this.combinations.title=x(n,e);let r=typeof e!=`number`||n.head.combinations[e]?.values!==null;r&&this.mode===`space`&&this.space?(this.space.onShow=e=>this.legend.show(e,n),this.space.show(e,t)):r&&this.plan.show(e,t),this.hooks.shown()}fit(){this.mode===`plan`?this.plan.fit():this.space?.fit()}setTool(e){this.plan.setTool(e);for(let[t,n]of Object.entries(this.toolButtons))n.setAttribute(`aria-pressed`,String(t===e))}setMode(e){this.mode=e;for(let[t,n]of Object.entries(this.modeButtons))n.setAttribute(`aria-pressed`,String(t===e));for(let t of Object.values(this.toolButtons))t.disabled=e===`space`;this.planBox.hidden=e!==`plan`,this.spaceBox.hidden=e!==`space`,e===`space`&&!this.space&&(this.space=new pf(this.spaceBox),this.space.setScene(this.scene)),this.scene&&this.show(this.choice,this.field)}read(e){let{scene:t,locator:n}=this;if(!e||!t||!n)return nv(this.reading,``);let r=`x ${e[0].toFixed(2)}  y ${e[1].toFixed(2)} m`,i=this.plan.shown?n.at(e[0],e[1]):null;if(i){let e=p(t,this.field);r+=`   ${Iu(e.symbol)} = ${tu(w(t,n,this.choice,this.field,i).value)} ${e.unit}`}nv(this.reading,r.replaceAll(`-`,`−`))}};function LC(e,t,n){return e?e.version===t&&n===0?`fresh`:`stale`:`none`}function RC(e,t,n,r,i){let a=e===`stale`?`These results are of an earlier state of the model. `:``;switch(t.kind){case`solving`:return`${a}Solving${t.text?`: ${t.text}`:` …`}`;case`refused`:return`${a}Not solved: ${t.message||`the model has faults`}`;case`cancelled`:return`${a}Solving was cancelled.`;default:return e===`none`?`Not solved yet.`:e===`stale`&&i>0?`${a}Mend the ${i===1?`fault`:`faults`} to renew them.`:e===`stale`?r?a:`${a}Solve to renew them.`:[n?.design??``,`Solved in ${zC(n?.seconds??0)}.`].filter(Boolean).join(` `)}}function zC(e){return e<10?`${e.toFixed(1)} s`:`${Math.round(e)} s`}function BC(e){let t=Q(`span`,{class:`status-words`}),n=Q(`progress`,{max:1,"aria-label":`progress of the solver`}),r=Q(`div`,{class:`result-status`,role:`status`},t,n),i=()=>{let{run:i,solved:a,doc:o}=e,s=LC(a,o?.version,e.waitingCount);nv(t,RC(s,i,a,e.autosolve,o?.faults.length??0)),t.title=t.textContent??``;let c=s===`fresh`&&!!a?.design;r.dataset.state=i.kind===`solving`?`solving`:i.kind===`refused`?`refused`:c?`failing`:s,n.hidden=i.kind!==`solving`,i.kind===`solving`&&i.share!==null?n.value=i.share:n.removeAttribute(`value`)};return e.on([`run`,`solved`,`doc`,`waiting`,`autosolve`],i),i(),r}function VC(e,t){let n=Q(`div`,{class:`empty-result`}),r=()=>{let{run:r,doc:i}=e,a=i?.faults.length??0;r.kind===`solving`?$(n,Q(`h3`,{},`Solving …`),Q(`p`,{},`The first result appears here.`)):r.kind===`refused`?$(n,Q(`h3`,{},`Not solved`),Q(`p`,{},r.message),...r.faults.map(e=>Q(`p`,{class:`quiet`},`${e.where}: got ${e.got}, expected ${e.expected}${e.mend?` — ${e.mend}`:``}`))):a>0?$(n,Q(`h3`,{},`No result yet`),Q(`p`,{},a===1?`Mend the fault first; it stands below the model.`:`Mend the ${a} faults first; they stand below the model.`)):$(n,Q(`h3`,{},`No result yet`),Q(`p`,{},`Solve the model to see settlement, contact pressure and moments here, or switch on Autosolve.`),Q(`button`,{type:`button`,class:`main`,onclick:t},`Solve`))};return e.on([`run`,`doc`,`solved`],r),{element:n,update:r}}function HC(e){let t=e?.design;if(!t)return[];let n=t.checks.filter(e=>e.status===`fails`||e.status===`attention`);return n.length===0?[Q(`p`,{class:`quiet`},t.headline)]:[Q(`p`,{class:`verdict bad`},t.headline),Q(`ul`,{},...n.map(e=>Q(`li`,{},`${e.name}: ${e.words}`)))]}function UC(e,t,n=null){let r=HC(n);if(!t)return $(e,...r,Q(`p`,{class:`empty`},`Choose a combination to see its figures.`));if(t.refused!==null)return $(e,...r,Q(`p`,{class:`verdict bad`},`${t.name} has no solution: ${t.refused}`));$(e,...r,Q(`div`,{class:`summary-sections`},...t.sections.map(e=>Q(`section`,{},Q(`h3`,{},e.title),Q(`table`,{class:`figures`},Q(`tbody`,{},...e.rows.map(e=>Q(`tr`,{},Q(`th`,{scope:`row`},e.label,e.symbol?` `:``,e.symbol?Fu(e.symbol):null),Q(`td`,{},typeof e.value==`number`?tu(e.value):e.value??``),Q(`td`,{class:`unit`},e.unit),Q(`td`,{class:`note`},e.note))))),...e.notes.map(e=>Q(`p`,{class:`quiet`},e))))))}var WC=new Set([`holds`,`too_large`,`load`,`reaction`]);function GC(e,t){let n=e.certificate?.too_large;return Array.isArray(n)&&n.includes(t)}function KC(e){return e.refused!==null||e.certificate===null?`refused`:e.certificate.holds===!0?`certified`:`not certified`}var qC={certified:`holds`,"not certified":`does not hold`,refused:`no solution`};function JC(e,t,n){if(!t)return $(e,Q(`p`,{class:`empty`},`Each solved combination is checked against the equations; the verdicts stand here.`));let r=[...new Set(t.combinations.flatMap(e=>Object.keys(e.certificate??{})))].filter(e=>!WC.has(e)),i=t.combinations.filter(e=>KC(e)!==`certified`).length,a=t.combinations.length,o=i===0?Q(`p`,{class:`verdict good`},`${a===1?`The result is`:`The results of all ${a} combinations are`} certified: equilibrium and contact conditions are satisfied on this mesh. This is no approval of the design.`):Q(`p`,{class:`verdict bad`},a===1?`This result must not be used.`:`${i} of ${a} combinations have no result that may be used.`),s=Q(`tr`,{},Q(`th`,{scope:`col`},`combination`),Q(`th`,{scope:`col`},`certificate`),...r.map(e=>Q(`th`,{scope:`col`},e.replaceAll(`_`,` `)))),c=t.combinations.map((e,t)=>{let i=KC(e),a=Q(`button`,{type:`button`,class:`link`,onclick:()=>n(t)},e.name||`combination ${t+1}`),o=i===`refused`?[Q(`td`,{class:`why`,colspan:Math.max(1,r.length)},e.refused??``)]:r.map(t=>Q(`td`,{class:GC(e,t)?`figure too-large`:`figure`},XC(e.certificate?.[t])));return Q(`tr`,{},Q(`th`,{scope:`row`},a),Q(`td`,{},Q(`span`,{class:`verdict-mark ${i===`certified`?`good`:`bad`}`},qC[i])),...o)});$(e,o,Z(`div`,{class:`wide`},Q(`table`,{class:`certificates`},Q(`thead`,{},s),Q(`tbody`,{},...c))))}function YC(e){let[t=``,n=``]=e.toExponential(1).split(`e`);return`${t.replace(`-`,`−`)}·10${[...n.replace(`+`,``)].map(e=>e===`-`?`⁻`:`⁰¹²³⁴⁵⁶⁷⁸⁹`[Number(e)]??``).join(``)}`}function XC(e){return typeof e==`number`?e===0||Math.abs(e)>=.001&&Math.abs(e)<1e4?tu(e):YC(e):typeof e==`boolean`?e?`yes`:`no`:typeof e==`string`?e:``}function ZC(e,t,n,r){return new QC(Q(`section`,{class:`result`,"aria-label":`result`}),e,t,n,r)}var QC=class{element;store;api;lost;stage;values;chart;chartOf=Q(`select`,{"aria-label":`combinations in the section`});chartTitle=Q(`span`,{class:`chart-title`});lines=Q(`select`,{"aria-label":`section line`});summaryBox=Q(`div`,{class:`lower-panel summary-box`});certificateBox=Q(`div`,{class:`lower-panel`});refusedBox=Q(`div`,{class:`refused-over`,role:`alert`,hidden:!0});lower;empty;full;summary=null;pick=null;section=null;fetching=0;shownRun=null;constructor(e,t,n,r,i){this.element=e,this.store=t,this.api=n,this.lost=i,this.stage=new IC({picked:e=>this.picked(e),cut:(e,t)=>this.cut({start:e,end:t,name:``}),shown:()=>this.refresh()});let a=Q(`div`,{class:`lower-panel value-box`}),o=Q(`div`,{class:`chart-place`}),s=Q(`div`,{class:`lower-panel section-box`},Q(`div`,{class:`chart-bar`},this.chartTitle,this.lines,this.chartOf),o);this.values=new F_(a),this.values.onField=e=>this.stage.show(this.stage.choice,e),this.chart=new A_(o),this.chart.onPlace=e=>this.stage.plan.markPlace(e),gd(e=>this.chart.setTheme(e)),this.lower=FC([{name:`summary`,label:`Summary`,panel:this.summaryBox,scrolls:!0},{name:`certificate`,label:`Certificate`,panel:this.certificateBox,scrolls:!0},{name:`values`,label:`Values`,panel:a},{name:`section`,label:`Section`,panel:s}],`about the result`);let c=Q(`div`,{class:`lower`},this.lower.bar,this.summaryBox,this.certificateBox,a,s);this.empty=VC(t,r),this.full=Q(`div`,{class:`result-full`,hidden:!0}),this.full.append(this.stage.bar,Q(`div`,{class:`stage-place`},this.stage.element,this.refusedBox),MC(this.full,`--stage-share`,`y`,.62,[.25,.85],`height of the picture`),c),e.append(Q(`h2`,{class:`unseen`},`Result`),BC(t),this.empty.element,this.full),this.chartOf.addEventListener(`change`,()=>this.drawChart()),this.lines.addEventListener(`change`,()=>this.chooseLine()),t.on([`solved`],()=>void this.fetch()),t.on([`doc`,`waiting`,`solved`],()=>{e.classList.toggle(`stale`,LC(t.solved,t.doc?.version,t.waitingCount)===`stale`)}),this.empty.update(),this.refresh()}async fetch(){let{solved:t}=this.store,n=this.fetching+=1;if(!t)return this.clear();if(t.run!==this.shownRun)try{let[e,i]=await Promise.all([this.api.scene(t.run),this.api.summary(t.run)]);if(n!==this.fetching)return;this.summary=i,this.full.hidden=!1,this.empty.element.hidden=!0,this.stage.take(r(e)),this.shownRun=t.run,this.refresh()}catch(t){if(n!==this.fetching)return;if(t instanceof B_||t instanceof V_)this.lost(t);else if(t instanceof U_||t instanceof e)this.store.say({kind:`bad`,text:`The result cannot be shown: ${t.message}`});else throw t}}clear(){this.shownRun=null,this.summary=null,this.pick=null,this.section=null,this.full.hidden=!0,this.empty.element.hidden=!1,this.empty.update(),this.stage.clear()}refresh(){let{stage:e,summary:t}=this,{choice:n}=e,r=typeof n==`number`?t?.combinations[n]??null:null;UC(this.summaryBox,r,t),JC(this.certificateBox,t,e=>this.choose(e));let i=t?.combinations.filter(e=>KC(e)!==`certified`).length??0;this.lower.mark(`certificate`,t?i>0?String(i):`✓`:``,i>0),this.refusedBox.hidden=r?.refused===null||r===null,$(this.refusedBox,Q(`h3`,{},`${r?.name??``} has no solution`),Q(`p`,{},r?.refused??``)),this.values.show(e.scene,e.locator,n,this.pick,e.field),this.fillLines(),this.fillChartOf(),this.drawChart()}choose(e){this.stage.show(e,this.stage.field)}picked(e){this.pick=e,this.stage.plan.markPick(e),this.lower.show(`values`),this.values.show(this.stage.scene,this.stage.locator,this.stage.choice,e,this.stage.field)}cut(e){this.section=e,this.stage.plan.markSection(e?[e.start,e.end]:null),e&&this.lower.show(`section`),e?.name||(this.lines.value=``),this.drawChart()}fillLines(){let e=this.stage.scene?.head.plan.lines??[],t=this.lines.value;$(this.lines,Q(`option`,{value:``},`section line …`),...e.map((e,t)=>Q(`option`,{value:String(t)},e.name||`line ${t+1}`))),this.lines.hidden=e.length===0,e[Number(t)]&&(this.lines.value=t)}chooseLine(){let e=this.stage.scene?.head.plan.lines[Number(this.lines.value||NaN)];this.cut(e?{start:e.start,end:e.end,name:e.name}:null)}fillChartOf(){let e=this.stage.scene?.head.combinations.filter(e=>e.values!==null)??[],t=[...new Set(e.map(e=>e.limit_state))],n=this.chartOf.value;$(this.chartOf,Q(`option`,{value:`this`},`combination shown`),e.length>1?Q(`option`,{value:`all`},`all combinations`):null,...t.length>1?t.map(e=>Q(`option`,{value:`state:${e}`},`all ${e} combinations`)):[]),this.chartOf.hidden=e.length<2,[...this.chartOf.options].some(e=>e.value===n)&&(this.chartOf.value=n)}drawChart(){let{section:e}=this,{scene:t,locator:n,field:r,choice:i}=this.stage;if(!e||!t||!n)return this.chartTitle.textContent=`Choose “Section” and click two places, or choose a section line of the model.`,this.chart.show(null);let a=this.chartOf.value,o=t.head.combinations.flatMap((e,t)=>e.values!==null&&(a===`all`||a===`state:${e.limit_state}`)?[t]:[]),s=v(i)||t.head.combinations[i]?.values?[i]:[],c=p(t,r),l=([e,t])=>`(${tu(e)}, ${tu(t)})`;this.chartTitle.textContent=`${Iu(c.symbol)} [${c.unit}] along ${e.name?`${e.name}: `:``}${l(e.start)} to ${l(e.end)} m`,this.chart.show({scene:t,locator:n,field:r,choices:o.length>0?o:s,...e})}},$C=/(?<comment>#[^\n]*)|(?<string>"""[\s\S]*?(?:"""|$)|'''[\s\S]*?(?:'''|$)|"(?:[^"\\\n]|\\.)*"?|'[^'\n]*'?)|(?<end>\n)|(?<space>[^\S\n]+)|(?<sign>[[\]{}=,])|(?<word>[^\s[\]{}=,#"']+)/g;function ew(e){let t=1;return Array.from(e.matchAll($C),e=>{let n={kind:Object.entries(e.groups??{}).find(([,e])=>e!==void 0)?.[0],text:e[0],line:t};return t+=e[0].split(`
`).length-1,n})}function tw(e){return new rw(ew(e)).read()}function nw(e,t){for(let n=t.length;n>0;--n){let r=e.get(Dv(t.slice(0,n)));if(r!==void 0)return r}return null}var rw=class{lines=new Map;counts=new Map;tokens;at=0;constructor(e){this.tokens=e.filter(e=>e.kind!==`comment`&&e.kind!==`space`)}read(){let e=[];for(;this.at<this.tokens.length;){let t=this.tokens[this.at];t.kind===`end`?this.at+=1:t.text===`[`?e=this.header(t.line):(this.pair(e),this.skipLine())}return this.lines}header(e){this.at+=1;let t=this.tokens[this.at]?.text===`[`;t&&(this.at+=1);let n=this.below([],this.key());if(this.skipLine(),!t)return this.note(n,e);let r=Dv(n),i=this.counts.get(r)??0;return this.counts.set(r,i+1),this.note(n,e),this.note([...n,i],e)}below(e,t){let n=e;return t.forEach((e,r)=>{n=[...n,e];let i=this.counts.get(Dv(n));i!==void 0&&r<t.length-1&&(n=[...n,i-1])}),n}note(e,t){let n=Dv(e);return this.lines.has(n)||this.lines.set(n,t),e}key(){let e=``,t=[];for(let t=this.tokens[this.at];t&&(t.kind===`word`||t.kind===`string`);t=this.tokens[++this.at])t.kind===`string`?e+=t.text.slice(1,-1).replaceAll(`.`,`\0`):e+=t.text;for(let n of e.split(`.`))t.push(n.replaceAll(`\0`,`.`));return t}pair(e){let t=this.tokens[this.at]?.line??1,n=this.at,r=this.below(e,this.key());this.tokens[this.at]?.text===`=`?(this.at+=1,this.note(r,t),this.value(r)):this.at===n&&(this.at+=1)}value(e){let t=this.tokens[this.at];t?.text===`[`?this.list(e):t?.text===`{`?this.braces(e):t&&t.kind!==`end`&&(this.at+=1)}list(e){this.at+=1;let t=0;for(let n=this.tokens[this.at];n;n=this.tokens[this.at]){if(n.text===`]`){this.at+=1;return}n.text===`,`&&(t+=1),n.text===`,`||n.kind===`end`||n.text===`=`||n.text===`}`?this.at+=1:this.value(this.note([...e,t],n.line))}}braces(e){this.at+=1;for(let t=this.tokens[this.at];t;t=this.tokens[this.at]){if(t.text===`}`){this.at+=1;return}if(t.text===`,`||t.kind===`end`)this.at+=1;else if(t.kind===`sign`)return;else this.pair(e)}}skipLine(){for(;this.at<this.tokens.length&&this.tokens[this.at]?.kind!==`end`;)this.at+=1}},iw=500;function aw(e,t){let n=Q(`textarea`,{class:`code-input`,spellcheck:`false`,autocapitalize:`off`,autocomplete:`off`,wrap:`off`,"aria-label":`case file as text`}),r=Q(`pre`,{class:`code-colours`,"aria-hidden":`true`}),i=Q(`pre`,{class:`code-gutter`,"aria-hidden":`true`}),a=Q(`div`,{class:`code`},i,Q(`div`,{class:`code-box`},r,n)),o=!1,s=0,c=``,l=av(iw,()=>{o=!1,t(n.value,s>0),s+=1}),u=()=>{if(a.closest(`[hidden]`))return;let t=new Map,s=tw(n.value);for(let n of o?[]:e.doc?.faults??[]){let e=n.line??nw(s,n.path)??1;t.set(e,[...t.get(e)??[],n])}let l=JSON.stringify([n.value,[...t]]);if(l===c)return;c=l;let u=ow(n.value);$(r,...u.flatMap((e,n)=>[cw(e,t.get(n+1)??[]),`
`])),$(i,...u.flatMap((e,n)=>[Q(`span`,{class:t.has(n+1)?`bad`:``},String(n+1)),`
`])),d()},d=()=>{r.style.transform=`translate(${-n.scrollLeft}px, ${-n.scrollTop}px)`,i.style.transform=`translateY(${-n.scrollTop}px)`};return n.addEventListener(`input`,()=>{o=!0,u(),l()}),n.addEventListener(`focus`,()=>s=0),n.addEventListener(`scroll`,d),n.addEventListener(`blur`,()=>l.flush()),n.addEventListener(`keydown`,e=>{e.key!==`Tab`||e.shiftKey||e.ctrlKey||e.altKey||a.dataset.leave!==`yes`&&(e.preventDefault(),n.setRangeText(`  `,n.selectionStart,n.selectionEnd,`end`),n.dispatchEvent(new Event(`input`)))}),n.addEventListener(`keyup`,e=>{e.key===`Escape`?a.dataset.leave=`yes`:e.key!==`Tab`&&delete a.dataset.leave}),e.on([`doc`,`waiting`],()=>{let t=e.waitingText??e.doc?.text??``;if(!o&&n.value!==t){let[e,r,i]=[n.selectionStart,n.selectionEnd,n.scrollTop];n.value=t,document.activeElement===n&&n.setSelectionRange(e,r),n.scrollTop=i}u()}),{element:a,reveal:(e,t)=>{let r=t??nw(tw(n.value),e)??1,i=n.value.split(`
`),a=i.slice(0,r-1).reduce((e,t)=>e+t.length+1,0);n.focus(),n.setSelectionRange(a,a+(i[r-1]?.length??0));let o=parseFloat(getComputedStyle(n).lineHeight)||18;n.scrollTop=Math.max(0,(r-4)*o),d()},refresh:u,flush:()=>l.flush()}}function ow(e){let t=[[]],n=ew(e),r=!1,i=!0;return n.forEach((e,a)=>{i&&e.kind!==`space`&&(r=e.text===`[`),i=e.kind===`end`||i&&e.kind===`space`;let o=sw(e,n[a+1]?.kind===`space`?n[a+2]:n[a+1],r);e.text.split(`
`).forEach((e,n)=>{n>0&&t.push([]),e&&t.at(-1)?.push({text:e,style:o})})}),t}function sw(e,t,n){return e.kind===`comment`||e.kind===`sign`?e.kind:n?`header`:t?.text===`=`?`key`:e.kind===`word`&&/^[-+.\d]/.test(e.text)?`figure`:e.kind}function cw(e,t){let n=t.map(e=>`got ${e.got}, expected ${e.expected}${e.mend?` — ${e.mend}`:``}`).join(`; `);return Q(`span`,{class:t.length>0?`line bad`:`line`},...e.map(e=>Q(`span`,{class:`t-${e.style}`},e.text)),n?Q(`span`,{class:`line-fault`},`   ◂ ${n}`):null)}function lw(e,t,n){let r=(e,t,n)=>Q(`button`,{type:`button`,title:t,onclick:n},e),i=Q(`button`,{type:`button`,class:`with-icon`,"aria-label":`undo`,onclick:()=>void n.undo()},tv(`undo`)),a=Q(`button`,{type:`button`,class:`with-icon`,"aria-label":`redo`,onclick:()=>void n.redo()},tv(`redo`)),o=Q(`span`,{class:`last-edit`,"aria-hidden":`true`}),s=Q(`span`,{class:`file-title`}),c=Q(`span`,{class:`unsaved`}),l=Q(`input`,{type:`checkbox`,role:`switch`,id:`autosolve`}),u=Q(`button`,{type:`button`,class:`main solve`,onclick:()=>void(e.run.kind===`solving`?n.cancel():n.solve())}),d=Q(`a`,{class:`button`,role:`button`,title:`Save the report of the last result as one HTML file`,download:``},`Report`),f=Q(`button`,{type:`button`,class:`with-icon`,title:`Light or dark`,"aria-label":`light or dark`,onclick:()=>hd(md()===`dark`?`light`:`dark`)},tv(`theme`));return l.addEventListener(`change`,()=>void n.autosolve(l.checked)),e.on([`doc`,`waiting`,`run`,`solved`,`autosolve`],()=>{let{doc:n,run:r}=e,f=n?.file??null;nv(s,f===null?`untitled`:f.split(/[\\/]/).at(-1)??f),s.title=f??`not saved yet`;let p=n!==null&&(n.dirty||e.waitingCount>0);nv(c,p?`● unsaved`:``),document.title=`${p?`● `:``}${s.textContent??``} – groundslab`,i.disabled=n?.can_undo!==!0,a.disabled=n?.can_redo!==!0,i.title=n?.can_undo?`Undo: ${n.undo_text} (Ctrl+Z)`:`Nothing to undo`,a.title=n?.can_redo?`Redo: ${n.redo_text} (Ctrl+Y)`:`Nothing to redo`,nv(o,n?.can_undo?n.undo_text:``);let m=r.kind===`solving`;nv(u,m?`Cancel`:`Solve`),u.classList.toggle(`solving`,m);let h=n?.faults.length??0;u.title=m?`Stop solving`:h>0?`There are faults to be mended first`:`Solve all combinations (F9)`,u.setAttribute(`aria-disabled`,String(!m&&h>0)),l.checked=e.autosolve;let{solved:g}=e;g?d.href=t.reportAddress(g.run):d.removeAttribute(`href`),d.setAttribute(`aria-disabled`,String(g===null))}),Q(`header`,{class:`top`},Q(`h1`,{class:`brand`},`groundslab`),Q(`div`,{class:`group`,role:`group`,"aria-label":`file`},r(`New`,`Start a new case`,()=>void n.fresh()),r(`Open …`,`Open a case file (Ctrl+O)`,()=>void n.open()),r(`Save`,`Save the case file (Ctrl+S)`,()=>void n.save()),r(`Save as …`,`Save under another name (Ctrl+Shift+S)`,()=>void n.saveAs())),Q(`div`,{class:`group`,role:`group`,"aria-label":`edits`},i,a),o,Q(`div`,{class:`file`},s,c),Q(`label`,{class:`switch`,for:`autosolve`,title:`Solve by itself after every edit`},l,Q(`span`,{class:`knob`}),`Autosolve`),u,d,f)}_d();var uw=new G_(EC()),dw=new qv,fw=new bv(uw,{base:()=>dw.doc?.version??0,adopt:(e,t)=>dw.setDoc(e,t),fits:(e,t)=>gw(e,t),refused:(e,t)=>dw.say({kind:`bad`,text:`“${e.text}” was not done: ${t}`}),lost:e=>pw.lost(e),changed:()=>dw.setWaiting(fw.waiting)}),pw=new vv(uw,dw,fw,{offered:_w,differs:yw}),mw=e=>fw.push(e),hw=e=>pw.lost(e);function gw(e,t){return e.edits.every(e=>{if(e.op===`text`)return!1;let n=e.op===`add`?e.path:e.path.slice(0,2);return jv(wv(dw.doc?.data??void 0,n),wv(t.data??void 0,n))})}async function _w(e){let{offer:t}=e;if(!t)return e;let n=t.changed===!0?[`The file itself has been changed since by another program; saving asks before it replaces that.`]:[],r=await ov(`Unsaved work was found`,[`An earlier run ended with changes that were not saved: ${t.file===null?`a case that was never saved`:t.file}, last changed ${bw(t.when)}.`,`Taking them up is a step that can be undone; the file on the disk stays as it is until you save.`,...n],[{label:`Put them aside`,value:!1},{label:`Take them up`,value:!0,main:!0}],null);return _w(await uw.restore(r))}function vw(e){let t=``;dw.on([`doc`],()=>{let{doc:n}=dw,r=n?.unkept??``,i=r||(n?.outside?`Another program has changed the file since it was read.`:``);if(i!==t){if(t=i,r)dw.say({kind:`bad`,text:`${r}. Save soon.`});else if(i&&n?.file){let{file:t}=n;dw.say({kind:`bad`,text:i,action:{label:`Read it anew`,run:()=>void e.openFile(t)}})}}})}async function yw(e,t){return ov(`Which text counts?`,[`The server now holds another text (${e.file??`not saved yet`}) than this page, which has unsaved changes.`],[{label:`Take the server's`,value:`server`},{label:`Keep the page's`,value:`page`,main:!0}],null)}function bw(e){let t=new Date(e);return Number.isNaN(t.getTime())?e:t.toLocaleString(void 0,{dateStyle:`medium`,timeStyle:`short`})}function xw(){if(!dw.schema||!dw.doc)return;let e={schema:new mC(dw.schema),memory:new Map,data:()=>dw.data,faults:()=>dw.doc?.faults??[],change:mw},t=aC(e,OC),n=XS(dw,e,mw),r=aw(dw,(e,t)=>mw({edits:[{op:`text`,value:e}],text:`edit the text`,...t?{merge:!0}:{}})),i=Q(`p`,{class:`broken`,role:`alert`,hidden:!0},`The text cannot be read at present; mend it under Text, or undo. Form and drawing show what was there before.`),a=Q(`div`,{class:`panel`},n.element),o=Q(`div`,{class:`panel scrolls`},t.element),s=Q(`div`,{class:`panel`},r.element),c=FC([{name:`plan`,label:`Plan`,panel:a},{name:`form`,label:`Form`,panel:o},{name:`text`,label:`Text`,panel:s}],`model`,e=>{e===`form`&&t.update(),e===`text`&&r.refresh()}),l=pC(dw,e=>{e.path.length===0||c.current()===`text`?(c.show(`text`),r.reveal(e.path,e.line)):c.current()===`plan`&&n.reveal(e.path)||(c.show(`form`),t.reveal(e.path))}),u=new lv(uw,dw,fw,hw,()=>{let{activeElement:e}=document;e instanceof HTMLInputElement&&e.dispatchEvent(new Event(`change`)),r.flush()},()=>l.open(),_w);vw(u);let d=Q(`section`,{class:`model`,"aria-label":`model`},Q(`h2`,{class:`unseen`},`Model`),c.bar,i,a,o,s,l.element),f=ZC(dw,uw,()=>void u.solve(),hw),p=Q(`main`,{class:`page`});p.append(d,MC(p,`--model-share`,`x`,.5,[.25,.75],`width of the model`),f.element),document.body.replaceChildren(lw(dw,uw,u),dv(dw,()=>pw.retry()),p,mv(dw)),dw.on([`data`,`doc`],()=>{c.current()===`form`&&t.update()}),dw.on([`doc`],()=>{i.hidden=!dw.broken,o.toggleAttribute(`inert`,dw.broken)}),document.addEventListener(`keydown`,e=>Sw(e,u));for(let e of[`doc`,`data`,`connection`,`run`,`solved`,`selection`,`waiting`,`autosolve`])dw.tell(e)}function Sw(e,t){let n=e.ctrlKey||e.metaKey,r=e.key.toLowerCase(),i=e.target instanceof HTMLTextAreaElement,a=t=>{e.preventDefault(),t()};document.querySelector(`dialog[open]`)||(n&&r===`s`?a(e.shiftKey?t.saveAs:t.save):n&&r===`o`?a(t.open):e.key===`F9`||n&&e.key===`Enter`?a(t.solve):n&&r===`z`&&!i?a(e.shiftKey?t.redo:t.undo):n&&r===`y`&&!i&&a(t.redo))}document.addEventListener(`keydown`,e=>{(e.key===`Tab`||e.key.startsWith(`Arrow`))&&(document.documentElement.dataset.input=`keys`)},{capture:!0}),document.addEventListener(`pointerdown`,()=>document.documentElement.dataset.input=`pointer`,{capture:!0}),DC(e=>{uw.setToken(e),pw.retry(!0)}),addEventListener(`beforeunload`,e=>{dw.waitingCount>0&&e.preventDefault()});var Cw=dw.on([`doc`],()=>{dw.doc?.data===null&&dw.doc.checking||(Cw(),xw())}),ww=Q(`p`,{class:`cover`},`Loading …`);document.body.replaceChildren(ww),dw.on([`connection`],()=>{ww.isConnected&&(ww.textContent=dw.connection===`stranger`?`This address is not valid any more. Open the address that groundslab app has printed.`:`The server does not answer. Start it with: groundslab app`)}),await pw.start();