/**
 * Boats as the operator sees them: pose, battery and link, the commands of each, and how it stands in its missions. Immutable values.
 *
 * <p>Does not belong here: when a snapshot is taken ({@code org.sami.crw.operator}), what is wrong with a boat ({@code
 * org.sami.crw.operator.alarm}), the proxy that commands it ({@code org.sami.crw.proxy}).
 */
@NullMarked
package org.sami.crw.operator.boat;

import org.jspecify.annotations.NullMarked;
