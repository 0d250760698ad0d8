/**
 * The base's end of all links: which vehicles there are, and what is asked of them.
 *
 * <p>Not here: plans, proxies and missions of a session.
 */
@NullMarked
package org.sami.mavlink.base;

import org.jspecify.annotations.NullMarked;
