/**
 * The one place from which the events of a fleet reach their subscribers.
 *
 * <p>Belongs here: who receives events, in which order and on which thread. Does not belong here: the events ({@code
 * org.sami.crw.fleet}), what makes them happen ({@code org.sami.crw.proxy}).
 */
@NullMarked
package org.sami.crw.fleet.publishing;

import org.jspecify.annotations.NullMarked;
