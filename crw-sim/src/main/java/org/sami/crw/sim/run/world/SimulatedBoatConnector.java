package org.sami.crw.sim.run.world;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.tcp.BaseListener;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.proxy.tcp.LinkReport;
import org.sami.crw.session.FleetConnector;
import org.sami.crw.session.picture.PictureAccess;
import org.sami.crw.sim.fleet.SimulatedFleet;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.Site;
import org.sami.spn.value.GeoPoint;

/**
 * Where boats of a run in process come from while it runs: behind each server's address lies one simulated boat, on the line
 * in addition to the others, which joins when a plan first connects to it. Nothing is sent to the address.
 */
public final class SimulatedBoatConnector implements FleetConnector {
    private final Executor executor;
    private final ProxyRegistry boats = new ProxyRegistry();
    private final Map<String, String> boatOfServer = new LinkedHashMap<>();
    private Optional<BaseListener> listener = Optional.empty();
    private Optional<SimulatedWater> water = Optional.empty();

    public SimulatedBoatConnector(Executor executor) {
        this.executor = executor;
    }

    @Override
    public void open(BaseListener newListener) {
        listener = Optional.of(newListener);
    }

    /** The base's data of a boat. */
    public Consumer<FleetEvent> listenerOf(String boat) {
        return listener.orElseThrow().found(boat);
    }

    /** There is water, with its boats; before the first plan runs. */
    public void launch(SimulatedWater newWater) {
        water = Optional.of(newWater);
        meetNewBoats();
    }

    private void meetNewBoats() {
        for (BoatProxy boat : fleet().proxies().all()) {
            if (boats.find(boat.boatId()).isEmpty()) {
                boats.add(boat);
                listener.orElseThrow().onBoat(boat);
            }
        }
    }

    @Override
    public Executor executor() {
        return executor;
    }

    @Override
    public ProxyRegistry boats() {
        return boats;
    }

    @Override
    public void expect(String boat) {
        // Every boat of this world is there from the start, or made on request.
    }

    @Override
    public CompletionStage<Boolean> disconnect(String boat) {
        Optional<BoatProxy> known = boats.find(boat);
        known.ifPresent(proxy -> {
            boats.remove(boat);
            proxy.retire("the boat has been removed");
            proxy.disconnect();
            listener.orElseThrow().onRemoved(boat);
        });
        return CompletableFuture.completedFuture(known.isPresent());
    }

    @Override
    public CompletionStage<Boolean> disconnect(BoatAddress address) {
        return Optional.ofNullable(boatOfServer.get(address.toString()))
                .map(this::disconnect)
                .orElseGet(() -> CompletableFuture.completedFuture(false));
    }

    @Override
    public CompletionStage<List<LinkReport>> links() {
        return CompletableFuture.completedFuture(List.of());
    }

    @Override
    public Optional<PictureAccess> pictures(String boat) {
        return fleet().boat(boat).map(one -> new DrawnPictures(boat, one.camera()));
    }

    @Override
    public void close() {
        boats.all().forEach(BoatProxy::disconnect);
    }

    @Override
    public void connect(Request request, Consumer<String> found) {
        String server = request.server().strip().toLowerCase(Locale.ROOT);
        if (server.isEmpty()) {
            throw new IllegalArgumentException("\"server\" is empty: there is no address to connect to");
        }
        String known = boatOfServer.get(server);
        if (known == null) {
            SimulatedFleet fleet = fleet();
            known = unused(request.name());
            join(known, fleet.boats().size() * SimulatedFleet.SPACING_M, 0);
            boatOfServer.put(server, known);
        }
        BoatProxy boat = fleet().boat(known).orElseThrow().proxy();
        if (boats.find(known).isEmpty()) {
            boats.add(boat);
            boat.reconnect();
        }
        found.accept(known);
    }

    @Override
    public List<String> create(String name, String color, GeoPoint start, int count) {
        SimulatedFleet fleet = fleet();
        if (count > FleetSettings.MOST_BOATS - fleet.boats().size()) {
            throw new IllegalArgumentException(count + " boats more would be too many; a run has at most "
                    + FleetSettings.MOST_BOATS + ", and there are "
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
        if (fleet().boats().size() >= FleetSettings.MOST_BOATS) {
            throw new IllegalArgumentException("a run has at most " + FleetSettings.MOST_BOATS + " boats");
        }
        fleet().join(id, eastM, northM, water.orElseThrow().hullOf(id));
        meetNewBoats();
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
