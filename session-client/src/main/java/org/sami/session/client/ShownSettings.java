package org.sami.session.client;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.sami.crw.operator.FleetModel;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.proxy.status.BoatTuning;
import org.sami.spn.host.Registration;

/** Waits until a setting that a boat has taken is seen here: rows of boats come a few times a second, replies at once. */
final class ShownSettings {
    /** Somebody else may have set it again meanwhile, and a connection may be lost. */
    private static final long MOST_MS = 2000;

    private ShownSettings() {}

    /** Completes when the model shows the boat as that, or after 2 s; on any thread. */
    static CompletionStage<Void> of(FleetModel fleet, String boat, Predicate<BoatTuning> as) {
        CompletableFuture<Void> shown = new CompletableFuture<>();
        Consumer<List<BoatSnapshot>> look = boats -> boats.stream()
                .filter(one -> one.boat().equals(boat))
                .filter(one -> one.settings().filter(as).isPresent())
                .findFirst()
                .ifPresent(one -> shown.complete(null));
        Registration listening = fleet.addListener(look);
        look.accept(fleet.snapshot());
        return shown.completeOnTimeout(null, MOST_MS, TimeUnit.MILLISECONDS)
                .whenComplete((seen, fault) -> listening.close());
    }
}
