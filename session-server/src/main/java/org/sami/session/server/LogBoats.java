package org.sami.session.server;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import org.sami.crw.proxy.file.BoatFileSource;
import org.sami.crw.session.Fleet;
import org.sami.session.api.LinkedBoat;

/** The boats whose logs are served. From any thread. */
interface LogBoats {
    /**
     * What is known of a boat.
     *
     * @param link where it answers; empty if it does nowhere
     * @param mayCome whether it may answer soon, such as a boat that a base which has just taken over does not reach yet
     */
    record Found(Optional<LinkedBoat> link, boolean mayCome) {}

    /** Looks for a boat by its name. */
    CompletionStage<Found> find(String boat);

    /** A link to a boat that is not open yet. */
    BoatFileSource files(LinkedBoat boat);

    /** Those of a session. */
    static LogBoats of(Fleet fleet) {
        return new LogBoats() {
            @Override
            public CompletionStage<Found> find(String boat) {
                CompletionStage<Boolean> known =
                        fleet.ask(boats -> boats.find(boat).isPresent());
                return fleet.links()
                        .thenCombine(known, (links, isKnown) -> {
                            boolean unknownLink =
                                    links.stream().anyMatch(one -> one.boatId().isEmpty());
                            return isKnown || unknownLink;
                        })
                        .thenCombine(fleet.linkedBoats(), (mayCome, linked) -> new Found(first(linked, boat), mayCome));
            }

            @Override
            public BoatFileSource files(LinkedBoat boat) {
                return fleet.files(boat);
            }
        };
    }

    private static Optional<LinkedBoat> first(List<LinkedBoat> linked, String boat) {
        return linked.stream().filter(one -> one.boat().equals(boat)).findFirst();
    }
}
