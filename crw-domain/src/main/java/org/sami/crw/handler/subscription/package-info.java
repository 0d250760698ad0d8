/**
 * What plans subscribe to: battery levels, areas that boats enter or leave, measurements; told as long as the tokens stand that wait for
 * it.
 *
 * <p>Does not belong here: readings that nobody waits for ({@code org.sami.crw.operator} shows them).
 */
package org.sami.crw.handler.subscription;
