package org.sami.crw.proxy.tcp;

import java.net.InetSocketAddress;
import java.util.Optional;

/**
 * One link of the base at a moment.
 *
 * @param boatId the boat that the address leads to; empty as long as that is not known
 * @param connected whether a connection stands now
 * @param connections how many have stood so far
 * @param lastEvent what happened last, in words; empty if nothing has
 * @param refused whether that is that somebody answered, and this base refused it or was turned away
 * @param failedTries how many connections could not be had, or ended, since a boat was heard over one
 * @param failingForMs how long ago the first of them was tried; 0 if there was none
 */
public record LinkReport(
        InetSocketAddress address,
        Optional<String> boatId,
        boolean connected,
        long connections,
        String lastEvent,
        boolean refused,
        long failedTries,
        long failingForMs) {}
