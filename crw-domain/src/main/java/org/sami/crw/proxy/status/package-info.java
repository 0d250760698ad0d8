/**
 * What boats say of themselves: pose, battery, mode, readings, settings in force, and whether they answer. Immutable values.
 *
 * <p>Does not belong here: the messages in which they say it ({@code org.sami.boat.link}), what the operator sees of it ({@code
 * org.sami.crw.operator.boat}).
 */
@NullMarked
package org.sami.crw.proxy.status;

import org.jspecify.annotations.NullMarked;
