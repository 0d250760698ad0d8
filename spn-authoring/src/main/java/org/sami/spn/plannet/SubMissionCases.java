package org.sami.spn.plannet;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;

/** What a transition supposes of the sub-missions that are followed on its in places, and what its firing does with those of its places. */
final class SubMissionCases {
    private final PlanNetWork work;
    private final Map<String, SubMode> modes;
    private final Selections selections;
    private final boolean overrides;
    /** Of several places with sub-missions it is not followed which of them brought back what. */
    private final Optional<VisitChild> only;

    /** Those that are shared and have returned, with how many robots their return must bring at least. */
    private final Map<SharedChild, Integer> returned = new LinkedHashMap<>();

    private final boolean hasOneSub;

    SubMissionCases(PlanNetWork work, Transition t, Map<String, SubMode> modes, Selections selections) {
        this.work = work;
        this.modes = modes;
        this.selections = selections;
        overrides = EventReach.reachesHeld(work.vocabulary(), t);
        List<String> subs = subPlaces(work, t);
        only = subs.size() == 1 && modes.getOrDefault(subs.get(0), SubMode.OPEN) == SubMode.COMPLETE
                ? work.child(subs.get(0))
                        .filter(VisitChild.class::isInstance)
                        .map(VisitChild.class::cast)
                        .filter(VisitChild::knowsReturns)
                : Optional.empty();
        hasOneSub = subs.size() == 1;
        for (String place : subs) {
            if (modes.get(place) == SubMode.RETURNED) {
                work.child(place)
                        .filter(SharedChild.class::isInstance)
                        .map(SharedChild.class::cast)
                        .ifPresent(child -> returned.put(child, leastRobots(work, t, child)));
            }
        }
    }

    /** How many robots of a return a transition asks for: of the place it may speak of those alone (R-SHR-6). */
    private static int leastRobots(PlanNetWork work, Transition t, SharedChild child) {
        return work.plan().inEdgesOf(t.id()).stream()
                .filter(edge -> edge.place().equals(child.place()))
                .flatMap(edge -> edge.requirements().stream())
                .filter(r -> r.match() == Match.AT_LEAST)
                .filter(r -> r.kind() == TokenKind.ANY_PROXY
                        || (r.kind() == TokenKind.ANY_TOKEN && !child.mayReturn(PlanToken.GENERIC)))
                .mapToInt(InRequirement::n)
                .max()
                .orElse(0);
    }

    private static List<String> subPlaces(PlanNetWork work, Transition t) {
        return work.plan().inEdgesOf(t.id()).stream()
                .map(InEdge::place)
                .distinct()
                .filter(work.possible()::hasSub)
                .toList();
    }

    /** Each way in which the sub-missions on its in places let a transition fire; one way where none of them is followed. */
    static List<Map<String, SubMode>> modes(PlanNetWork work, Transition t) {
        List<Map<String, SubMode>> all = new ArrayList<>(List.of(Map.of()));
        if (EventReach.reachesHeld(work.vocabulary(), t)) {
            return all;
        }
        List<String> subs = subPlaces(work, t);
        for (String place : subs) {
            Optional<FollowedChild> child = work.child(place);
            if (child.isPresent()) {
                List<Map<String, SubMode>> more = new ArrayList<>();
                for (Map<String, SubMode> one : all) {
                    for (SubMode mode : child.get().modes()) {
                        Map<String, SubMode> with = new HashMap<>(one);
                        with.put(place, mode);
                        more.add(with);
                    }
                }
                all = more;
            }
        }
        boolean speaks = work.plan().outEdgesOf(t.id()).stream()
                .flatMap(edge -> edge.requirements().stream())
                .anyMatch(r -> r.kind() == TokenKind.SUB_MISSION_TOKENS);
        // who speaks of sub-mission tokens waits for a completion (R-SUB-6)
        all.removeIf(one -> speaks
                && !subs.isEmpty()
                && one.size() == subs.size()
                && one.values().stream().allMatch(SubMode.VACANT::equals));
        return all;
    }

    /** Whether the requirements take all sub-mission tokens. */
    private boolean takesAll() {
        return selections.all().stream()
                .filter(s -> s.isOf(TokenKind.SUB_MISSION_TOKENS))
                .allMatch(s -> s.requirement().takesAll());
    }

    private boolean removes() {
        return selections.all().stream().anyMatch(s -> s.isOf(TokenKind.SUB_MISSION_TOKENS) && s.removes());
    }

    private boolean speaks() {
        return selections.all().stream().anyMatch(s -> s.isOf(TokenKind.SUB_MISSION_TOKENS));
    }

    /** What an option supposes of whether sub-missions brought its token back; what came back and leaves is used. */
    void returned(TokenOption option) {
        only.flatMap(child -> child.back(option.token)).ifPresent(at -> {
            if (speaks() && option.isReturned) {
                option.arcs.atLeast(at, 1);
            } else if (speaks() && takesAll()) {
                option.arcs.below(at, 1);
            }
            if (option.isReturned && removes()) {
                option.arcs.empty(at);
            }
        });
        option.left.stream()
                .flatMap(place -> work.child(place).stream())
                .flatMap(child -> child.back(option.token).stream())
                .forEach(option.arcs::empty);
        returned.keySet().forEach(child -> child.used(option));
    }

    /** Whether a token is surely one of the sub-mission tokens that are selected: the return brought it, and all of them are. */
    boolean isSurelySelected(TokenOption option) {
        return hasOneSub
                && speaks()
                && takesAll()
                && returned.keySet().stream().anyMatch(child -> option.present.contains(child.place()));
    }

    /** The cases of a firing by the returns of shared sub-missions that it uses. */
    List<CaseArcs> returns(CaseArcs arcs, List<TokenOption> chosen) {
        List<CaseArcs> cases = List.of(arcs);
        for (Map.Entry<SharedChild, Integer> child : returned.entrySet()) {
            cases = cases.stream()
                    .flatMap(one -> child.getKey().used(one, chosen, child.getValue()).stream())
                    .toList();
        }
        return cases;
    }

    /** The cases of a firing, with what it does to sub-missions. */
    List<CaseArcs> of(CaseArcs arcs, Set<Integer> entered, Set<String> left, boolean returnsSome, boolean ends) {
        modes.forEach((place, mode) -> work.child(place).ifPresent(child -> child.suppose(mode, arcs)));
        if (speaks() && only.isPresent()) {
            if (returnsSome) {
                only.get().use(arcs);
            } else {
                only.get().useNew(arcs);
            }
        }
        List<CaseArcs> cases = List.of(arcs);
        for (FollowedChild child : ends ? List.<FollowedChild>of() : work.children()) {
            cases = cases.stream()
                    .flatMap(one -> of(child, one, entered, left).stream())
                    .toList();
        }
        return cases;
    }

    private List<CaseArcs> of(FollowedChild child, CaseArcs arcs, Set<Integer> entered, Set<String> left) {
        int edges = 0;
        for (int edge : entered) {
            OutEdge out = selections.edges().get(edge);
            edges += out.place().equals(child.place()) ? 1 : 0;
        }
        boolean isByNobody = work.places().nobody(child.place()).stream().anyMatch(arcs::adds);
        boolean isPulled = overrides && left.contains(child.place());
        return edges > 0 || isPulled ? child.changed(arcs, edges, isByNobody, isPulled) : List.of(arcs);
    }
}
