/**
 * What the domain does when a plan asks: one handler for each output event that is neither a decision nor the engine's own, and
 * what boats report as news to plans.
 *
 * <p>Belongs here: the way from an activation to services, boats and the operator, and back as inputs. Does not belong here: how
 * a boat is kept at its command ({@code crw.proxy}), algorithms ({@code crw.service}), firing rules.
 *
 * <p>Threads: all handlers, and all that is heard of boats, run on one serial executor, the one that drives the proxies ("the
 * fleet's thread"). So nothing here is locked. What comes from the engine's thread is handed over to it. {@link
 * org.sami.crw.handler.CrwDomain} puts it together.
 */
package org.sami.crw.handler;
