/**
 * How messages of MAVLink lie in their bytes, worked out once for each kind from the library's definitions.
 *
 * <p>Belongs here: what is needed to read a payload. Does not belong here: links, signatures, what a message means.
 */
@NullMarked
package org.sami.mavlink.format;

import org.jspecify.annotations.NullMarked;
