/**
 * Simulated links: frames travel between a proxy and a boat server in virtual time, through the codec and without sockets.
 */
package org.sami.crw.sim.link;
