/**
 * Simulated links: frames travel between a proxy and a boat server in virtual time, without sockets and, by default, without the codec.
 */
package org.sami.crw.sim.link;
