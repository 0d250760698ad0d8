/**
 * The base's TCP links to its boats: one connection per address, that comes again by itself, and one thread on which all
 * proxies of the base live.
 *
 * <p>What a proxy does over a link belongs to {@link org.sami.crw.proxy}; here is only how its frames come and go, and which
 * boat an address leads to.
 */
@NullMarked
package org.sami.crw.proxy.tcp;

import org.jspecify.annotations.NullMarked;
