package org.sami.crw.sim.boat;

import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeMap;
import org.sami.crw.sim.layer.CurrentField;
import org.sami.crw.sim.layer.DepthGrid;
import org.sami.crw.sim.layer.WaterLayers;
import org.sami.crw.sim.vessel.ForeignVessels;

/**
 * What there is on the water of simulated boats besides the conditions, as it stands among the settings of a session's journal: a session that is resumed has
 * the same water.
 *
 * @param vessels that are not of the base
 * @param layers of the water, by place
 */
public record WaterAround(ForeignVessels vessels, WaterLayers layers) {
    /** Nothing. */
    public static final WaterAround NONE = new WaterAround(ForeignVessels.NONE, WaterLayers.NONE);

    private static final String VESSELS = "water.vessels";
    private static final String DEPTHS = "water.depths";
    private static final String CURRENTS = "water.currents";

    public WaterAround {
        Objects.requireNonNull(vessels, "vessels");
        Objects.requireNonNull(layers, "layers");
    }

    /**
     * What the settings of a journal say.
     *
     * @throws IllegalArgumentException if that makes no sense
     */
    public static WaterAround of(Map<String, String> settings) {
        return new WaterAround(
                Optional.ofNullable(settings.get(VESSELS))
                        .map(ForeignVessels::parse)
                        .orElse(ForeignVessels.NONE),
                new WaterLayers(
                        Optional.ofNullable(settings.get(DEPTHS)).map(DepthGrid::parse),
                        Optional.ofNullable(settings.get(CURRENTS)).map(CurrentField::parse)));
    }

    /** As settings of a journal; nothing of what there is not. */
    public Map<String, String> settings() {
        Map<String, String> settings = new TreeMap<>();
        if (!vessels.isEmpty()) {
            settings.put(VESSELS, vessels.toString());
        }
        layers.depths().ifPresent(depths -> settings.put(DEPTHS, depths.toString()));
        layers.currents().ifPresent(currents -> settings.put(CURRENTS, currents.toString()));
        return settings;
    }

    /** This, and what it lacks as it was before. */
    public WaterAround orAsBefore(WaterAround before) {
        return new WaterAround(
                vessels.isEmpty() ? before.vessels : vessels,
                new WaterLayers(
                        layers.depths().or(before.layers::depths),
                        layers.currents().or(before.layers::currents)));
    }

    /** Puts boats on this water; before the first is launched. */
    public void under(SimulatedBoatsOnTcp boats) {
        boats.among(vessels);
        boats.on(layers);
    }
}
