/**
 * The boats near a session: those that announce themselves on the network next to those that it has, and connecting to many of them at once. No window.
 *
 * <p>Does not belong here: announcing and finding ({@code org.sami.crw.proxy.near}), whether a boat is ready ({@code org.sami.crw.operator.alarm}).
 */
@NullMarked
package org.sami.crw.session.near;

import org.jspecify.annotations.NullMarked;
