/**
 * Notifications of proxies to their listener: in order, after the work that caused them, and even if a listener throws.
 *
 * <p>Not here: the events that a fleet publishes from them ({@code org.sami.crw.fleet}).
 */
@NullMarked
package org.sami.crw.proxy.listener;

import org.jspecify.annotations.NullMarked;
