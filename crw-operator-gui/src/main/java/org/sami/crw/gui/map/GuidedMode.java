package org.sami.crw.gui.map;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.boat.FleetStopState;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.explanation.ExplainedCommand;
import org.sami.session.api.GuidedBoats;
import org.sami.session.api.RefusedException;
import org.sami.session.api.WayByHand;
import org.sami.spn.protocol.Ids;
import org.sami.spn.value.GeoPoint;

/**
 * Sends boats somewhere without a plan. What the operator wants comes before what missions want, which waits and goes on afterwards: at once
 * after a way, and when the boats are given back after they were held.
 */
final class GuidedMode {
    /** The variable of a project with the place to which boats return. */
    static final String HOME = "@home";

    private final OperatorContext context;

    GuidedMode(OperatorContext context) {
        this.context = context;
    }

    private GuidedBoats byHand() {
        return context.session().byHand();
    }

    /** Has the selected boats go to a point, each in a way of its own around what is to be avoided; those that cannot come there stay. */
    void goTo(GeoPoint point) {
        each(boat -> byHand().goTo(boat, point)
                .thenApply(way -> does(boat, ExplainedCommand.SENT) + words(way) + before(boat)));
    }

    /**
     * Has the selected boats go home: aircraft land where they took off, boats go to a place of the project.
     *
     * @param ofProject empty where the project has none
     */
    void goHome(Optional<GeoPoint> ofProject) {
        each(boat -> {
            boolean flies = context.models()
                    .fleet()
                    .boat(boat)
                    .filter(BoatSnapshot::flies)
                    .isPresent();
            return flies
                    ? byHand().goHome(boat).thenApply(way -> boat + " flies home and lands" + before(boat))
                    : toHome(boat, ofProject)
                            .thenApply(way -> does(boat, ExplainedCommand.SENT) + words(way) + before(boat));
        });
    }

    private CompletionStage<WayByHand> toHome(String boat, Optional<GeoPoint> ofProject) {
        return ofProject
                .map(home -> byHand().goTo(boat, home))
                .orElseGet(() -> CompletableFuture.failedFuture(
                        new RefusedException("the project has no point " + HOME + " to which " + boat + " returns")));
    }

    private static String words(WayByHand way) {
        String length = String.format(Locale.ROOT, ", %.0f m", way.lengthM());
        String around = way.turns() ? " around what is to be avoided" : "";
        return length + around + (way.doubts().isEmpty() ? "" : "; see the message about its way");
    }

    /** Has the selected boats stay where they are, until they are given back. */
    void hold() {
        each(boat -> byHand().hold(boat)
                .thenApply(held -> does(boat, ExplainedCommand.HELD) + " until it is given back" + before(boat)));
    }

    private boolean isStopped(String boat) {
        return context.models().fleetStop().snapshot().stops(boat);
    }

    /** The same words as in lists and explanations. */
    private String does(String boat, ExplainedCommand command) {
        return boat + (isStopped(boat) ? " is to " + command.infinitive() : " " + command.does());
    }

    /** The additional text for a stopped boat: it has its command and does not move. */
    private String before(String boat) {
        return isStopped(boat) ? "; " + context.models().fleetStop().snapshot().words(boat) : "";
    }

    /** Withdraws the operator's commands from the selected boats: they continue with those of missions. */
    void giveBack() {
        each(boat -> byHand().giveBack(boat).thenApply(given -> boat + " goes on with what missions want"));
    }

    /** Gives a command to each selected boat, and reports the results in one notice, because the line has room for one. */
    private void each(Function<String, CompletionStage<String>> done) {
        List<String> boats = selected().stream().map(BoatSnapshot::boat).toList();
        List<String> told = new ArrayList<>();
        List<String> refused = new ArrayList<>();
        for (String boat : boats) {
            done.apply(boat).whenComplete((words, fault) -> {
                if (fault == null) {
                    told.add(words);
                } else {
                    refused.add(RefusedException.reason(fault));
                }
                if (told.size() + refused.size() == boats.size()) {
                    tell(told, refused);
                }
            });
        }
    }

    private void tell(List<String> told, List<String> refused) {
        List<String> all = new ArrayList<>(refused);
        all.addAll(told);
        String words = String.join("; ", all);
        if (refused.isEmpty()) {
            context.notices().show(words);
        } else {
            context.notices().refused(words);
        }
    }

    private List<BoatSnapshot> selected() {
        return context.boats().boats().stream()
                .flatMap(boat -> context.models().fleet().boat(boat).stream())
                .toList();
    }

    /** The boats that it concerns and the commands that wait meanwhile, in one line; shown beforehand. */
    String consequence() {
        List<String> boats = context.boats().boats();
        List<Long> missions = selected().stream()
                .flatMap(boat -> boat.command().stream())
                .map(BoatCommand::mission)
                .filter(mission -> mission != Ids.NONE)
                .distinct()
                .toList();
        String waits = missions.isEmpty()
                ? "no mission wants anything of " + they(boats) + " now"
                : "what "
                        + String.join(
                                "; ",
                                missions.stream().map(context.titles()::words).toList())
                        + (missions.size() == 1 ? " wants" : " want") + " of " + they(boats) + " waits meanwhile";
        return String.join(", ", boats) + ": " + stopped(boats) + waits;
    }

    private String stopped(List<String> boats) {
        FleetStopState state = context.models().fleetStop().snapshot();
        String armed = boats.stream()
                .filter(state.overridden()::containsKey)
                .map(boat -> boat + " " + state.overridden().get(boat) + "; ")
                .collect(Collectors.joining());
        List<String> stopped = boats.stream()
                .filter(boat -> isStopped(boat) && !state.overridden().containsKey(boat))
                .toList();
        return armed + waits(stopped, boats);
    }

    private static String waits(List<String> stopped, List<String> boats) {
        return stopped.isEmpty()
                ? ""
                : (stopped.equals(boats) ? "stopped" : String.join(", ", stopped) + " stopped")
                        + "; nothing moves before the release; ";
    }

    private static String they(List<String> boats) {
        return boats.size() == 1 ? "it" : "them";
    }
}
