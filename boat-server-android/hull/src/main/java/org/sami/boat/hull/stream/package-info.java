/**
 * Streams that may vanish and come back, and lines of bounded length in them.
 *
 * <p>Not here: what the lines say.
 */
package org.sami.boat.hull.stream;
