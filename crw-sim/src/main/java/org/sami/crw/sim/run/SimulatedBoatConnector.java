package org.sami.crw.sim.run;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.crw.proxy.BoatConnector;
import org.sami.crw.sim.fleet.SimulatedFleet;
import org.sami.spn.value.GeoPoint;

/**
 * Where boats of a run in process come from while it runs: behind each server's address lies one simulated boat, on the line
 * beside the others, which joins when a plan first connects to it. Nothing is sent to the address.
 */
final class SimulatedBoatConnector implements BoatConnector {
    private final Map<String, String> boatOfServer = new LinkedHashMap<>();
    private Optional<SimulatedWater> water = Optional.empty();
    private Optional<BaseStation> base = Optional.empty();

    /** There is water, and a base that gets to know boats; before the first plan runs. */
    void open(SimulatedWater newWater, BaseStation newBase) {
        water = Optional.of(newWater);
        base = Optional.of(newBase);
    }

    @Override
    public void connect(Wanted wanted, Consumer<String> found) {
        String server = wanted.server().strip().toLowerCase(Locale.ROOT);
        if (server.isEmpty()) {
            throw new IllegalArgumentException("\"server\" is empty: there is no address to connect to");
        }
        String known = boatOfServer.get(server);
        if (known == null) {
            SimulatedFleet fleet = fleet();
            known = unused(wanted.name());
            join(known, fleet.boats().size() * SimulatedFleet.SPACING_M, 0);
            boatOfServer.put(server, known);
        }
        found.accept(known);
    }

    @Override
    public List<String> create(String name, String color, GeoPoint start, int count) {
        SimulatedFleet fleet = fleet();
        if (count > RunSettings.Fleet.MOST_BOATS - fleet.boats().size()) {
            throw new IllegalArgumentException(count + " boats more would be too many; a run has at most "
                    + RunSettings.Fleet.MOST_BOATS + ", and there are "
                    + fleet.boats().size());
        }
        double eastM = fleet.frame().eastM(start.latDeg(), start.lonDeg());
        double northM = fleet.frame().northM(start.latDeg(), start.lonDeg());
        if (Math.hypot(eastM, northM) > Site.REACH_M) {
            throw new IllegalArgumentException("boats would begin at " + start.latDeg() + ", " + start.lonDeg()
                    + ", which is beyond the simulated water");
        }
        List<String> created = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            String id = unused(count == 1 ? name : name.strip() + (i + 1));
            join(id, eastM + i * SimulatedFleet.SPACING_M, northM);
            created.add(id);
        }
        return created;
    }

    private void join(String id, double eastM, double northM) {
        if (fleet().boats().size() >= RunSettings.Fleet.MOST_BOATS) {
            throw new IllegalArgumentException("a run has at most " + RunSettings.Fleet.MOST_BOATS + " boats");
        }
        fleet().join(id, eastM, northM);
        base.orElseThrow().know(fleet().proxies());
    }

    private String unused(String wanted) {
        String name = wanted.isBlank() ? "boat" : wanted.strip();
        String id = name;
        for (int i = 2; fleet().boat(id).isPresent(); i++) {
            id = name + " " + i;
        }
        return id;
    }

    private SimulatedFleet fleet() {
        return water.orElseThrow(() -> new IllegalStateException("there is no water yet"))
                .fleet();
    }
}
