/**
 * The vocabulary as data: event types with their fields, roles and decisions, markups and task classes of one domain.
 *
 * <p>Belongs here: immutable declarations and their look-up by name or alias. Does not belong here: reading them from
 * files ({@code spn.json}) and doing what they ask (handlers of the domain).
 */
@NullMarked
package org.sami.spn.vocabulary;

import org.jspecify.annotations.NullMarked;
