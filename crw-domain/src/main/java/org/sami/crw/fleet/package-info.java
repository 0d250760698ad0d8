/**
 * What happens to the boats of a base, as events of one sealed type that anybody can subscribe to.
 *
 * <p>Belongs here: the events and the one place that tells them. Does not belong here: what makes them happen ({@code
 * org.sami.crw.proxy}), what plans make of them ({@code org.sami.crw.handler}), what the operator sees ({@code
 * org.sami.crw.operator}).
 */
@NullMarked
package org.sami.crw.fleet;

import org.jspecify.annotations.NullMarked;
