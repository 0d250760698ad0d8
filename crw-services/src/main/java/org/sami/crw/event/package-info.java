/**
 * The domain's values as records: what handlers and services work with, and its conversion to and from the typed trees
 * that events carry.
 *
 * <p>Belongs here: records of the types that the vocabulary declares, readers of field values that several handlers
 * share. Does not belong here: what handlers do with them ({@code crw.handler}), the declaration of the types
 * (domain-config).
 */
@NullMarked
package org.sami.crw.event;

import org.jspecify.annotations.NullMarked;
