/**
 * Subscriptions of plans: battery levels, areas that boats enter or leave, measurements; they report while the waiting tokens stand.
 *
 * <p>Not here: readings without a subscription ({@code org.sami.crw.operator} shows them).
 */
@NullMarked
package org.sami.crw.handler.subscription;

import org.jspecify.annotations.NullMarked;
