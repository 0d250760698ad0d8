package org.sami.session.client;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.Predicate;
import java.util.function.Supplier;
import org.sami.boat.link.GainAxis;
import org.sami.boat.link.Gains;
import org.sami.boat.link.LostLinkAction;
import org.sami.crw.operator.OperatorModels;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.proxy.explanation.BoatExplanation;
import org.sami.crw.proxy.file.BoatFileSource;
import org.sami.crw.proxy.gateway.LinkStatus;
import org.sami.crw.proxy.status.BoatTuning;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.session.api.FrontFleet;
import org.sami.session.api.LinkedBoat;
import org.sami.session.api.RefusedException;
import org.sami.session.record.LinkStatusJson;
import org.sami.session.record.LostLinkWishRows;
import org.sami.spn.value.GeoPoint;

/** The boats of a session in another process. A boat is claimed for this person before it is driven by hand, and given back with it. Safe for use by several threads. */
final class RemoteFleet implements FrontFleet {
    private final RemoteRequests server;
    private final Supplier<OperatorModels> models;
    private final Supplier<Optional<LostLinkAction>> wish;
    private final Supplier<Optional<TicketedBase>> holder;
    private final Set<String> claimed = new HashSet<>(); // guarded by itself
    private long unclaimed; // how often all were; guarded by claimed

    /**
     * Its boats.
     *
     * @param wish what the session wishes of them when their link is lost; from any thread
     * @param holder the base that gives their logs; from any thread
     */
    RemoteFleet(
            RemoteRequests server,
            Supplier<OperatorModels> models,
            Supplier<Optional<LostLinkAction>> wish,
            Supplier<Optional<TicketedBase>> holder) {
        this.server = server;
        this.wish = wish;
        this.holder = holder;
        this.models = models;
    }

    /** The server has ended all of this person's claims here. A claim whose reply is still to arrive was one of them. */
    void unclaimed() {
        synchronized (claimed) {
            unclaimed++;
            claimed.clear();
        }
    }

    private static ObjectNode forBoat(String what, String boat) {
        return ServerRequests.message("boat").put("do", what).put("boat", boat);
    }

    private CompletionStage<Void> tell(String what, String boat) {
        return server.ask(forBoat(what, boat)).thenAccept(done -> {});
    }

    @Override
    public CompletionStage<String> connect(BoatAddress address) {
        return server.ask(ServerRequests.message("boat").put("do", "connect").put("address", address.toString()))
                .thenApply(done -> done.path("text").asText());
    }

    @Override
    public CompletionStage<Boolean> disconnect(String boat) {
        return server.ask(forBoat("disconnect", boat)).thenApply(done -> true);
    }

    @Override
    public CompletionStage<Boolean> disconnect(BoatAddress address) {
        return server.ask(ServerRequests.message("boat").put("do", "disconnect").put("address", address.toString()))
                .thenApply(done -> true);
    }

    @Override
    public CompletionStage<List<String>> addSimulated(String name, GeoPoint start, int count) {
        return server.ask(forBoat("add", name)
                        .put("lat", start.latDeg())
                        .put("lon", start.lonDeg())
                        .put("count", count))
                .thenApply(RemoteFleet::boats);
    }

    private static List<String> boats(JsonNode done) {
        return LinkRowReader.texts(done.path("boats"));
    }

    @Override
    public CompletionStage<BoatExplanation> why(String boat) {
        return models.get()
                .fleet()
                .boat(boat)
                .map(BoatSnapshot::why)
                .map(CompletableFuture::completedFuture)
                .orElseGet(
                        () -> CompletableFuture.failedFuture(new RefusedException("there is no boat '" + boat + "'")));
    }

    @Override
    public CompletionStage<List<LinkedBoat>> linkedBoats() {
        return server.ask(ServerRequests.message("linkedBoats")).thenApply(done -> {
            List<LinkedBoat> boats = new ArrayList<>();
            done.path("links")
                    .forEach(one -> boats.add(new LinkedBoat(
                            one.path("boat").asText(),
                            BoatAddress.parse(one.path("address").asText()))));
            return boats;
        });
    }

    @Override
    public CompletionStage<List<LinkStatus>> linkStatuses(String boat) {
        return server.ask(ServerRequests.message("linkStatuses").put("boat", boat))
                .thenApply(done -> LinkStatusJson.read(done.path("links")));
    }

    @Override
    public BoatFileSource files(LinkedBoat boat) {
        return new RemoteBoatFiles(boat, holder);
    }

    @Override
    public CompletionStage<Void> takeCommand(String boat) {
        return tell("take", boat);
    }

    @Override
    public CompletionStage<Void> askForCommand(String boat) {
        return tell("ask", boat);
    }

    @Override
    public CompletionStage<Void> handOver(String boat) {
        return tell("watch", boat);
    }

    @Override
    public CompletionStage<Void> handOver(String boat, String clientId) {
        return server.ask(forBoat("give", boat).put("client", clientId)).thenAccept(done -> {});
    }

    @Override
    public CompletionStage<Void> teleoperate(String boat, double thrust, double rudder) {
        return claim(boat)
                .thenCompose(ready -> server.ask(ServerRequests.message("drive")
                        .put("boat", boat)
                        .put("thrust", thrust)
                        .put("rudder", rudder)))
                .thenAccept(done -> {});
    }

    @Override
    public CompletionStage<List<Long>> clearBlock(String boat) {
        return server.ask(forBoat("clear", boat)).thenApply(done -> List.of());
    }

    @Override
    public CompletionStage<Void> cancel(String boat, String commandId) {
        return server.ask(forBoat("cancel", boat).put("command", commandId)).thenAccept(done -> {});
    }

    @Override
    public CompletionStage<Void> sendPathAgain(String boat) {
        return tell("resend", boat);
    }

    private static ObjectNode setting(String boat, String which) {
        return ServerRequests.message("set").put("boat", boat).put("setting", which);
    }

    /** Asks for a setting; completes when the boat has taken it, and shows it here. */
    private CompletionStage<Void> set(ObjectNode setting, Predicate<BoatTuning> as) {
        String boat = setting.path("boat").asText();
        return server.onFront(server.ask(setting)
                .thenCompose(done -> ShownSettings.of(models.get().fleet(), boat, as)));
    }

    @Override
    public CompletionStage<Void> setGains(String boat, GainAxis axis, Gains gains) {
        return set(
                setting(boat, axis.name().toLowerCase(Locale.ROOT))
                        .put("p", gains.proportional())
                        .put("i", gains.integral())
                        .put("d", gains.derivative()),
                own -> gains.equals(axis == GainAxis.HEADING ? own.heading() : own.speed()));
    }

    @Override
    public CompletionStage<Void> setVelocityMultiplier(String boat, double multiplier) {
        return set(
                setting(boat, "velocity").put("multiplier", multiplier), own -> own.velocityMultiplier() == multiplier);
    }

    @Override
    public CompletionStage<Void> setLostLinkAction(String boat, LostLinkAction action) {
        return set(
                setting(boat, "lost-link").put("action", action.name().toLowerCase(Locale.ROOT)),
                own -> own.lostLinkAction() == action);
    }

    @Override
    public Optional<LostLinkAction> lostLinkWish() {
        return wish.get();
    }

    @Override
    public CompletionStage<Void> wishLostLink(Optional<LostLinkAction> action) {
        return server.ask(ServerRequests.message("set")
                        .put("setting", "lost-link-wish")
                        .put("action", LostLinkWishRows.word(action)))
                .thenAccept(done -> {});
    }

    /** Claims a boat for this person, unless that is done. */
    CompletionStage<Void> claim(String boat) {
        long before;
        synchronized (claimed) {
            if (claimed.contains(boat)) {
                return CompletableFuture.completedFuture(null);
            }
            before = unclaimed;
        }
        return server.ask(ServerRequests.message("claim").put("boat", boat)).thenAccept(done -> {
            synchronized (claimed) {
                if (before == unclaimed) {
                    claimed.add(boat);
                }
            }
        });
    }

    @Override
    public CompletionStage<Void> handBack(String boat) {
        return server.ask(ServerRequests.message("giveBack").put("boat", boat)).thenAccept(done -> {
            synchronized (claimed) {
                claimed.remove(boat);
            }
        });
    }

    @Override
    public CompletionStage<Void> stop(String boat) {
        return tell("stop", boat);
    }

    @Override
    public CompletionStage<Void> release(String boat) {
        return tell("release", boat);
    }

    @Override
    public CompletionStage<List<String>> stopAll() {
        return server.ask(ServerRequests.message("stopFleet")).thenApply(RemoteFleet::boats);
    }

    @Override
    public CompletionStage<List<String>> releaseAll() {
        return server.ask(ServerRequests.message("releaseFleet")).thenApply(RemoteFleet::boats);
    }
}
