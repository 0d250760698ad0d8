package org.sami.crw.proxy;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.proxy.command.BoatCommand;

/** The boats of the base, in the order in which they became known. For the thread that drives the proxies. */
public final class ProxyRegistry {
    private final Map<String, BoatProxy> byId = new LinkedHashMap<>();

    /**
     * Adds a boat.
     *
     * @throws IllegalArgumentException if there is one with its id
     */
    public void add(BoatProxy proxy) {
        if (byId.putIfAbsent(proxy.boatId(), proxy) != null) {
            throw new IllegalArgumentException("there are two boats named " + proxy.boatId());
        }
    }

    /** Forgets a boat; returns whether it was known. */
    public boolean remove(String boatId) {
        return byId.remove(boatId) != null;
    }

    /** The boat with this id. */
    public Optional<BoatProxy> find(String boatId) {
        return Optional.ofNullable(byId.get(boatId));
    }

    /** All boats, in order. */
    public Collection<BoatProxy> all() {
        return Collections.unmodifiableCollection(byId.values());
    }

    /** The ids of all boats, in order. */
    public List<String> boatIds() {
        return List.copyOf(byId.keySet());
    }

    /** Takes back what a mission has for any boat: the mission has ended or was aborted. Returns what was taken back. */
    public List<BoatCommand> withdraw(long mission) {
        List<BoatCommand> withdrawn = new ArrayList<>();
        for (BoatProxy proxy : all()) {
            withdrawn.addAll(proxy.commands().withdraw(mission));
        }
        return withdrawn;
    }

    /** Lets time pass for all boats, in order. */
    public void tick(long nowMs) {
        for (BoatProxy proxy : all()) {
            proxy.tick(nowMs);
        }
    }

    /** Stops every boat, latched until {@link #fleetRelease}. */
    public void fleetStop() {
        all().forEach(BoatProxy::fleetStop);
    }

    /** Ends the fleet stop. */
    public void fleetRelease() {
        all().forEach(BoatProxy::fleetRelease);
    }
}
