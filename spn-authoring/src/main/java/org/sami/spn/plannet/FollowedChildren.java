package org.sami.spn.plannet;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.sami.spn.flow.TokenType;
import org.sami.spn.model.Action;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TokenKind;
import org.sami.spn.vocabulary.EventRole;

/** Which sub-missions of a plan a net follows, and why others are left open. */
final class FollowedChildren {
    private final PlanNetWork work;
    private final List<String> ancestors;
    private final int depth;
    private final AbstractionList abstractions;

    /**
     * The children of one mission.
     *
     * @param ancestors the plans on the way to it, its own included
     * @param depth how many levels below it are followed
     */
    FollowedChildren(PlanNetWork work, List<String> ancestors, int depth, AbstractionList abstractions) {
        this.work = work;
        this.ancestors = ancestors;
        this.depth = depth;
        this.abstractions = abstractions;
    }

    /** Makes the places of those that are followed, and of their children; lists the others. */
    void make() {
        for (Place place : work.plan().places()) {
            if (place.subMissions().isEmpty()) {
                continue;
            }
            Optional<String> reason = reason(place);
            if (reason.isPresent()) {
                abstractions.wider(
                        work.path(place.id()),
                        "the sub-mission of \"" + title(place)
                                + "\" may end at any time and bring back any of its tokens" + reason.get());
                continue;
            }
            PlanNetWork child = new PlanNetWork(work, place, childOf(place).orElseThrow());
            List<String> plans = new ArrayList<>(ancestors);
            plans.add(child.plan().id());
            new FollowedChildren(child, plans, depth - 1, abstractions).make();
            if (place.subMissions().get(0).shared()) {
                followShared(place, child);
            } else {
                followVisits(place, child);
            }
        }
    }

    private void followShared(Place place, PlanNetWork child) {
        work.follow(new SharedChild(work.places(), place.id(), child, work.team()), child);
        abstractions.wider(
                work.path(place.id()),
                "the shared sub-mission of \"" + title(place)
                        + "\" is followed but for the order of its returns, who came with whom, and how many generic"
                        + " tokens came; once nobody enters the place by an edge, or an interrupt takes tokens out, it"
                        + " may bring back any of its tokens at any time");
    }

    private void followVisits(Place place, PlanNetWork child) {
        work.follow(
                new VisitChild(
                        work.places(),
                        place.id(),
                        child,
                        robots().toList(),
                        robots().filter(token -> work.possible().isLoose(token, place.id()))
                                .collect(Collectors.toSet()),
                        !work.possible().isMadeByChildren(place.id()) && isKnownWhoIsBack(place.id())),
                child);
        abstractions.wider(
                work.path(place.id()),
                "the sub-mission of \"" + title(place)
                        + "\" is followed for one visit at a time: once there are more, or an interrupt takes"
                        + " tokens out, it may end at any time and bring back any of its tokens, until nobody is"
                        + " there");
        if (leavesReturnsOpen(place.id())) {
            abstractions.wider(
                    work.path(place.id()),
                    "which tokens the sub-mission of \"" + title(place) + "\" brings back is followed only in part");
        }
    }

    private Stream<PlanToken> robots() {
        return work.team().stream().filter(token -> token.type() == TokenType.PROXY);
    }

    /** Whether who came back is known of robots that stand there several times: all who were brought back are taken together, and all copies. */
    private boolean isKnownWhoIsBack(String place) {
        return robots().noneMatch(token -> work.possible().isLoose(token, place))
                || work.plan().inEdges().stream()
                        .filter(edge -> edge.place().equals(place))
                        .flatMap(edge -> work.plan().outEdgesOf(edge.transition()).stream())
                        .flatMap(out -> out.requirements().stream())
                        .allMatch(r -> r.takesAll()
                                || r.action() == Action.ADD
                                || r.kind() == TokenKind.GENERIC
                                || r.kind() == TokenKind.UNCONDITIONAL);
    }

    /** Whether a firing out of the place may speak of sub-mission tokens of which it is not known whether they came back. */
    private boolean leavesReturnsOpen(String place) {
        Plan plan = work.plan();
        return plan.inEdges().stream()
                .filter(edge -> edge.place().equals(place))
                .anyMatch(edge -> {
                    List<OutRequirement> returning = plan.outEdgesOf(edge.transition()).stream()
                            .flatMap(out -> out.requirements().stream())
                            .filter(r -> r.kind() == TokenKind.SUB_MISSION_TOKENS)
                            .toList();
                    boolean isOnly = plan.inEdgesOf(edge.transition()).stream()
                            .allMatch(in ->
                                    in.place().equals(place) || !work.possible().hasSub(in.place()));
                    boolean isKnown = isOnly
                            && returning.stream().allMatch(OutRequirement::takesAll)
                            && !work.possible().isMadeByChildren(place)
                            && !work.possible().comes(place, PlanToken.GENERIC)
                            && work.team().stream().noneMatch(work.possible()::isCopied);
                    return !returning.isEmpty() && !isKnown;
                });
    }

    private Optional<Plan> childOf(Place place) {
        return work.project().plan(place.subMissions().get(0).plan());
    }

    /** Why it is not followed; empty where it is. */
    private Optional<String> reason(Place place) {
        if (depth <= 0) {
            return Optional.of(work.parent().isEmpty() ? "" : ": it is deeper than asked for");
        }
        if (place.subMissions().size() > 1) {
            return Optional.of(": several run at once");
        }
        Optional<Plan> child = childOf(place).filter(plan -> plan.startPlace().isPresent());
        if (child.isEmpty() || place.end()) {
            return Optional.of(": it never starts");
        }
        if (ancestors.contains(child.get().id())) {
            return Optional.of(": its plan runs itself");
        }
        boolean hasTasks = !child.get().tasks().isEmpty()
                || work.team().stream().anyMatch(token -> token.type() == TokenType.TASK)
                || roles(child.get()).anyMatch(role -> role == EventRole.TASKS_GENERATED);
        if (hasTasks) {
            return Optional.of(": there are tasks");
        }
        if (roles(child.get()).anyMatch(FollowedChildren::isAboutItsOutcome)) {
            return Optional.of(": it may be aborted or completed");
        }
        if (work.team().stream().noneMatch(token -> work.possible().comes(place.id(), token))) {
            return Optional.of(": no token comes there");
        }
        if (place.subMissions().get(0).shared() && copies(place, child.get())) {
            return Optional.of(": it is shared by all visits, and its plan makes copies of boats");
        }
        return Optional.empty();
    }

    /** Whether a boat may be several times in a shared sub-mission, as it may in its place or as the plan copies it, so that one that was brought back may come once more. */
    private boolean copies(Place place, Plan child) {
        PossibleTokens inside = work.possibleIn(place, child);
        return robots().anyMatch(inside::isCopied);
    }

    private static boolean isAboutItsOutcome(EventRole role) {
        return role == EventRole.ABORT_MISSION
                || role == EventRole.ABORT_RECEIVED
                || role == EventRole.COMPLETE_MISSION
                || role == EventRole.COMPLETE_RECEIVED;
    }

    private Stream<EventRole> roles(Plan plan) {
        return Stream.concat(
                        plan.places().stream()
                                .flatMap(p -> p.outputs().stream())
                                .map(output -> output.type()),
                        plan.transitions().stream()
                                .flatMap(t -> t.inputs().stream())
                                .map(input -> input.type()))
                .flatMap(type -> work.vocabulary().event(type).stream())
                .map(event -> event.role());
    }

    private static String title(Place place) {
        return place.name().isBlank() ? place.id() : place.name();
    }
}
