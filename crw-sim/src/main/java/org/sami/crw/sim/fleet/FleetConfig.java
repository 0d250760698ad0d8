package org.sami.crw.sim.fleet;

import java.util.Objects;
import java.util.function.UnaryOperator;
import org.sami.boat.server.ServerConfig;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.proxy.link.ProxyConfig;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.hull.HullConfig;
import org.sami.crw.sim.layer.WaterLayers;
import org.sami.crw.sim.link.PipeConfig;
import org.sami.crw.sim.link.Radio;
import org.sami.crw.sim.vessel.ForeignVessels;

/**
 * What is set for the boats of a simulated fleet; the same for all.
 *
 * @param conditions on the water; the seed of what there is to be measured is the fleet's
 * @param server changes the boat servers' defaults
 * @param trackEveryMs virtual time between two points of the recorded tracks
 * @param radio over which the links are: a boat out of its range has no link
 * @param vessels that are not of the fleet, on the plane of the fleet
 * @param layers of the water, by place
 */
public record FleetConfig(
        HullConfig hull,
        Conditions conditions,
        PipeConfig pipe,
        ProxyConfig proxy,
        UnaryOperator<ServerConfig.Builder> server,
        long trackEveryMs,
        Radio radio,
        ForeignVessels vessels,
        WaterLayers layers) {

    /** The defaults of all parts; tracks at 1 Hz. */
    public static final FleetConfig DEFAULT = new FleetConfig(
            HullConfig.DEFAULT,
            Conditions.CALM,
            PipeConfig.DEFAULT,
            ProxyConfig.DEFAULT,
            UnaryOperator.identity(),
            1000,
            Radio.PERFECT,
            ForeignVessels.NONE,
            WaterLayers.NONE);

    /** Refuses tracks without a period. */
    public FleetConfig {
        Objects.requireNonNull(hull, "hull");
        Objects.requireNonNull(conditions, "conditions");
        Objects.requireNonNull(pipe, "pipe");
        Objects.requireNonNull(proxy, "proxy");
        Objects.requireNonNull(server, "server");
        Objects.requireNonNull(radio, "radio");
        Objects.requireNonNull(vessels, "vessels");
        Objects.requireNonNull(layers, "layers");
        if (trackEveryMs < SimulatedFleet.TICK_MS) {
            throw new IllegalArgumentException("a track point every " + trackEveryMs + " ms");
        }
    }

    /** What these hulls are. */
    public RobotKind robots() {
        return hull.rotors().isPresent() ? RobotKind.COPTER : RobotKind.BOAT;
    }

    /** The same with other hulls. */
    public FleetConfig withHull(HullConfig newHull) {
        return new FleetConfig(newHull, conditions, pipe, proxy, server, trackEveryMs, radio, vessels, layers);
    }

    /** The same on other water. */
    public FleetConfig withConditions(Conditions newConditions) {
        return new FleetConfig(hull, newConditions, pipe, proxy, server, trackEveryMs, radio, vessels, layers);
    }

    /** The same for who notes down tracks otherwise: boats only know where they began. */
    public FleetConfig withoutTracks() {
        return new FleetConfig(hull, conditions, pipe, proxy, server, Long.MAX_VALUE, radio, vessels, layers);
    }

    /** The same with other links. */
    public FleetConfig withPipe(PipeConfig newPipe) {
        return new FleetConfig(hull, conditions, newPipe, proxy, server, trackEveryMs, radio, vessels, layers);
    }

    /** The same with another base side. */
    public FleetConfig withProxy(ProxyConfig newProxy) {
        return new FleetConfig(hull, conditions, pipe, newProxy, server, trackEveryMs, radio, vessels, layers);
    }

    /** The same with other boat servers. */
    public FleetConfig withServer(UnaryOperator<ServerConfig.Builder> newServer) {
        return new FleetConfig(hull, conditions, pipe, proxy, newServer, trackEveryMs, radio, vessels, layers);
    }

    /** The same with links over a radio. */
    public FleetConfig withRadio(Radio newRadio) {
        UnaryOperator<ServerConfig.Builder> before = server;
        return new FleetConfig(
                hull,
                conditions,
                newRadio.over(pipe),
                proxy,
                builder -> before.apply(builder).lostLinkAction(newRadio.lostLink()),
                trackEveryMs,
                newRadio,
                vessels,
                layers);
    }

    /** The same on water with other vessels. */
    public FleetConfig withVessels(ForeignVessels others) {
        return new FleetConfig(hull, conditions, pipe, proxy, server, trackEveryMs, radio, others, layers);
    }

    /** The same on water that differs by place. */
    public FleetConfig withLayers(WaterLayers newLayers) {
        return new FleetConfig(hull, conditions, pipe, proxy, server, trackEveryMs, radio, vessels, newLayers);
    }
}
