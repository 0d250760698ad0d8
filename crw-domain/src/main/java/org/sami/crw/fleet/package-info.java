/**
 * What happens to the boats of a base, as events of one sealed type that anybody can subscribe to.
 *
 * <p>Belongs here: the events. Does not belong here: who receives them ({@code org.sami.crw.fleet.publishing}), what makes them happen ({@code
 * org.sami.crw.proxy}), what plans make of them ({@code org.sami.crw.handler}), what the operator sees ({@code
 * org.sami.crw.operator}).
 */
@NullMarked
package org.sami.crw.fleet;

import org.jspecify.annotations.NullMarked;
