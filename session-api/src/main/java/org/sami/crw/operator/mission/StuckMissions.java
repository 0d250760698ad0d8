package org.sami.crw.operator.mission;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.sami.crw.fleet.FleetWants;
import org.sami.crw.handler.motion.WayQuestions;
import org.sami.crw.operator.mission.FailedAnswers.Failure;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.MissionView;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.MissionStatus;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Finds missions that cannot go on by themselves (docs/session.md): something failed at a place, and nothing is under way there; or nothing at all is under way
 * for the mission and its sub-missions, and no news, press or answer leads on. A mission that waits for a press, a boat or a reading alone is well.
 */
public final class StuckMissions {
    private final Vocabulary vocabulary;
    private final EngineView view;
    private final FleetWants wants;
    private final FailedAnswers failed;
    private final Outlooks outlooks;

    private StuckMissions(Vocabulary vocabulary, EngineView view, FleetWants wants, FailedAnswers failed) {
        this.vocabulary = vocabulary;
        this.view = view;
        this.wants = wants;
        this.failed = failed;
        outlooks = new Outlooks(vocabulary, view, wants, failed);
    }

    /**
     * Looks at all missions, in order of creation; on the thread that owns the state.
     *
     * @param nowMillis on the session's clock; since then they count as stuck
     */
    public static List<StuckMission> of(
            Vocabulary vocabulary, EngineView view, FleetWants wants, FailedAnswers failed, long nowMillis) {
        StuckMissions look = new StuckMissions(vocabulary, view, wants, failed);
        return view.missions().stream()
                .filter(mission -> mission.parent() == Ids.NONE)
                .flatMap(root -> look.inTree(root, nowMillis).stream())
                .toList();
    }

    private List<StuckMission> inTree(MissionView root, long nowMillis) {
        List<MissionView> tree =
                view.missions().stream().filter(one -> one.root() == root.id()).toList();
        List<StuckMission> stuck = tree.stream()
                .map(mission -> failedIn(root, mission, nowMillis))
                .flatMap(Optional::stream)
                .toList();
        return stuck.isEmpty() ? dead(root, tree, nowMillis).stream().toList() : stuck;
    }

    /** Something failed at a place of the mission, and nothing is under way there. */
    private Optional<StuckMission> failedIn(MissionView root, MissionView mission, long nowMillis) {
        if (mission.status() == MissionStatus.HALTED) {
            return Optional.of(stuck(
                    root,
                    mission,
                    nowMillis,
                    "it was halted: it fired without end",
                    List.of("Abort the mission"),
                    Set.of(),
                    List.of()));
        }
        if (failed.isEmpty()) {
            return Optional.empty();
        }
        List<Outlooks.Of> all = outlooks.of(mission);
        boolean otherPlacesMove = all.stream().anyMatch(StuckMissions::leadsOn);
        for (Outlooks.Of one : all) {
            if (one.outlook() != Outlook.NEVER) {
                continue;
            }
            List<Outlooks.Of> beside = all.stream()
                    .filter(other -> other.places().stream().anyMatch(one.places()::contains))
                    .toList();
            boolean maybeElsewhere =
                    otherPlacesMove && beside.stream().anyMatch(other -> other.outlook() == Outlook.OTHERS);
            if (beside.stream().noneMatch(other -> other.outlook() == Outlook.UNDER_WAY) && !maybeElsewhere) {
                return Optional.of(failedAt(root, mission, one, beside, nowMillis));
            }
        }
        return Optional.empty();
    }

    private static boolean leadsOn(Outlooks.Of one) {
        return one.outlook() == Outlook.UNDER_WAY || one.outlook() == Outlook.NEWS;
    }

    private StuckMission failedAt(
            MissionView root, MissionView mission, Outlooks.Of dead, List<Outlooks.Of> beside, long nowMillis) {
        Set<String> boats = new LinkedHashSet<>();
        Set<String> reasons = new LinkedHashSet<>();
        for (Activation activation : dead.dead()) {
            Set<String> standing = Outlooks.standing(mission, activation);
            List<Failure> all = failed.of(activation.id());
            List<Failure> ofBoats = all.stream()
                    .filter(failure -> standing.contains(failure.boat()))
                    .toList();
            ofBoats.forEach(failure -> boats.add(failure.boat()));
            if (ofBoats.isEmpty()) {
                boats.addAll(standing);
            }
            (ofBoats.isEmpty() ? all : ofBoats).forEach(failure -> reasons.add(failure.reason()));
        }
        String where = dead.dead().stream()
                .map(Activation::place)
                .distinct()
                .map(place -> "'" + place(mission, place) + "'")
                .collect(Collectors.joining(" and "));
        List<String> news =
                beside.stream().flatMap(one -> one.news().stream()).distinct().toList();
        String what = (boats.isEmpty() ? "it" : words(boats)) + " cannot go on in " + where
                + reasons.stream()
                        .filter(reason -> !reason.isBlank())
                        .map(": %s"::formatted)
                        .findFirst()
                        .orElse("")
                + (news.isEmpty() ? "" : "; only " + String.join(" or ", news) + " would lead on");
        List<String> help = new ArrayList<>();
        List<Activation> again =
                dead.dead().stream().filter(one -> !isNotWanted(one)).toList();
        if (!again.isEmpty()) {
            help.add("Send it again");
        }
        Stream.concat(Stream.of(dead), beside.stream())
                .flatMap(one -> one.presses().stream())
                .distinct()
                .forEach(name -> help.add("press '" + name + "'"));
        help.add("complete or abort the mission");
        return stuck(root, mission, nowMillis, what, help, boats, again);
    }

    /** Whether the operator has refused all of it: then it is not asked again. */
    private boolean isNotWanted(Activation activation) {
        return failed.of(activation.id()).stream()
                .allMatch(failure -> failure.reason().startsWith(WayQuestions.REJECTED_WAY));
    }

    private static String words(Set<String> boats) {
        List<String> all = List.copyOf(boats);
        return all.size() == 1
                ? all.get(0)
                : String.join(", ", all.subList(0, all.size() - 1)) + " and " + all.get(all.size() - 1);
    }

    private String place(MissionView mission, String id) {
        return view.planOf(mission.id())
                .flatMap(plan -> plan.place(id))
                .map(Place::name)
                .filter(name -> !name.isEmpty())
                .orElse(id);
    }

    /** Nothing in a mission and its sub-missions leads on. */
    private Optional<StuckMission> dead(MissionView root, List<MissionView> tree, long nowMillis) {
        if (tree.stream().anyMatch(mission -> wants.wantsSomething(mission.id()))) {
            return Optional.empty();
        }
        for (MissionView mission : tree) {
            boolean waits = mission.status() == MissionStatus.WAITING
                    || view.decisions().stream().anyMatch(decision -> decision.mission() == mission.id())
                    || outlooks.of(mission).stream()
                            .anyMatch(one ->
                                    (leadsOn(one) && !isParent(one, mission, tree)) || one.outlook() == Outlook.PRESS);
            if (waits) {
                return Optional.empty();
            }
        }
        List<Wait> stands = tree.stream()
                .flatMap(mission -> BlockedPlaces.of(vocabulary, view, mission).stream())
                .toList();
        String where = stands.stream()
                .filter(wait -> !wait.place().isEmpty())
                .map(wait -> "'" + wait.place() + "'")
                .distinct()
                .collect(Collectors.joining(", "));
        String why = stands.stream()
                .flatMap(wait -> wait.transitions().stream())
                .flatMap(transition -> transition.reasons().stream()
                        .map(reason -> "; '" + transition.name() + "' cannot fire: " + withoutStop(reason)))
                .findFirst()
                .orElse("");
        return Optional.of(stuck(
                root,
                root,
                nowMillis,
                "nothing is under way" + (where.isEmpty() ? ", no place is marked" : ", it stands in " + where) + why,
                List.of("Complete or abort the mission"),
                Set.of(),
                List.of()));
    }

    /** Whether a transition only waits for a sub-mission, which is looked at itself. */
    private boolean isParent(Outlooks.Of one, MissionView mission, List<MissionView> tree) {
        return one.outlook() == Outlook.UNDER_WAY
                && !view.whyNotEnabled(mission.id(), one.transition().id())
                        .awaitedSubMissions()
                        .isEmpty()
                && tree.stream().anyMatch(child -> child.parent() == mission.id());
    }

    private static String withoutStop(String sentence) {
        return sentence.endsWith(".") ? sentence.substring(0, sentence.length() - 1) : sentence;
    }

    /** What people call it, as its tab does. */
    private static String title(MissionView root, Optional<Plan> plan) {
        return root.name().isBlank() || root.name().equals(root.plan())
                ? plan.map(Plan::title).orElse(root.plan())
                : root.name();
    }

    private StuckMission stuck(
            MissionView root,
            MissionView mission,
            long nowMillis,
            String what,
            List<String> help,
            Set<String> boats,
            List<Activation> again) {
        Optional<Plan> plan = view.planOf(root.id());
        List<String> ways = new ArrayList<>(help);
        String last = ways.remove(ways.size() - 1);
        String all = ways.isEmpty() ? last : String.join(", ", ways) + ", or " + last;
        String words = all.substring(0, 1).toUpperCase(Locale.ROOT) + all.substring(1);
        return new StuckMission(
                mission.id(),
                root.id(),
                title(root, plan),
                nowMillis,
                what,
                words,
                List.copyOf(boats),
                again.stream().map(Activation::id).toList());
    }
}
