/**
 * What proxies tell their listener, and how: in order, after the work that caused it, and whatever a listener throws.
 *
 * <p>Does not belong here: the events that a fleet publishes of it ({@code org.sami.crw.fleet}).
 */
package org.sami.crw.proxy.listener;
