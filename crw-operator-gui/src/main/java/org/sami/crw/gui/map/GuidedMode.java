package org.sami.crw.gui.map;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.atomic.AtomicLong;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.proxy.BoatCommand;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.FollowPath;
import org.sami.crw.proxy.KeepStation;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/**
 * Sends boats somewhere without a plan. What the operator wants comes before what missions want, which waits and goes on afterwards: at once
 * after a way, and when the boats are given back after they were held.
 */
final class GuidedMode {
    private static final double RADIUS_M = 5;

    private final OperatorContext context;
    private final AtomicLong commands = new AtomicLong();
    private final String process = Long.toString(System.currentTimeMillis(), Character.MAX_RADIX);

    GuidedMode(OperatorContext context) {
        this.context = context;
    }

    /** Has the selected boats go to a point, each in a way of its own. */
    void goTo(GeoPoint point) {
        each(boat -> FollowPath.goTo(id(boat), Ids.NONE, Ids.NONE, point, Priority.CRITICAL), "goes there");
    }

    /** Has the selected boats stay where they are, until they are given back. */
    void hold() {
        for (BoatSnapshot boat : selected()) {
            boat.pose()
                    .ifPresent(pose -> submit(
                            boat.boat(),
                            new KeepStation(
                                    id(boat.boat()),
                                    Ids.NONE,
                                    Ids.NONE,
                                    pose.position(),
                                    RADIUS_M,
                                    Priority.CRITICAL,
                                    false),
                            "holds its place until it is given back"));
        }
    }

    /** Takes back what the operator wanted of the selected boats: they go on with what missions want. */
    void giveBack() {
        for (BoatSnapshot boat : selected()) {
            String id = boat.boat();
            context.tell(
                    context.session().fleet().ask(boats -> boats.find(id).map(proxy -> proxy.withdraw(Ids.NONE))),
                    id + " goes on with what missions want");
        }
    }

    private interface Wanted {
        BoatCommand of(String boat);
    }

    private void each(Wanted wanted, String done) {
        selected().forEach(boat -> submit(boat.boat(), wanted.of(boat.boat()), done));
    }

    private void submit(String boat, BoatCommand command, String done) {
        CompletionStage<Optional<BoatProxy>> sent = context.session().fleet().ask(boats -> {
            Optional<BoatProxy> proxy = boats.find(boat);
            proxy.ifPresent(found -> {
                found.withdraw(Ids.NONE); // the latest wish counts
                found.submit(command);
            });
            return proxy;
        });
        context.tell(sent, boat + " " + done);
    }

    private String id(String boat) {
        return "guided-" + process + "-" + commands.incrementAndGet() + "-" + boat;
    }

    private List<BoatSnapshot> selected() {
        return context.boats().boats().stream()
                .flatMap(boat -> context.models().fleet().boat(boat).stream())
                .toList();
    }

    /** Whom it concerns and what waits meanwhile, in one line; said before it is done. */
    String consequence() {
        List<String> boats = context.boats().boats();
        List<Long> missions = selected().stream()
                .flatMap(boat -> boat.command().stream())
                .map(BoatCommand::mission)
                .filter(mission -> mission != Ids.NONE)
                .distinct()
                .toList();
        String waits = missions.isEmpty()
                ? "no mission wants anything of them now"
                : "what "
                        + String.join(
                                "; ",
                                missions.stream().map(context.titles()::words).toList())
                        + (missions.size() == 1 ? " wants" : " want") + " of them waits meanwhile";
        return String.join(", ", boats) + ": " + waits;
    }
}
