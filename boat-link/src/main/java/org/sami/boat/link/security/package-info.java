/**
 * Who is at the other end of a link: keys, their fingerprints, the peers that are paired, and TLS over a socket. Trust is by pinned fingerprints alone;
 * no certificate authority, no clock and no host name counts.
 *
 * <p>Here: what base and boat share, with the platform's own cryptography (JSSE, JCA), so that it runs on a phone. Java 8 level.
 */
package org.sami.boat.link.security;
