package org.sami.spn.statespace;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Plan;

/** Finds steps that make ever more tokens, or ask forever more, and never take any of it away. */
final class TokensPileUp implements SpaceQuestion {
    static final String CODE = "W-PILES-UP";
    private static final int MOST = 5;

    @Override
    public String id() {
        return "piles-up";
    }

    @Override
    public String title() {
        return "Piling up";
    }

    @Override
    public String help() {
        return "Looks for runs in which tokens pile up without bound: each round adds the same ones, and nothing takes"
                + " them away.";
    }

    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                CODE,
                "Each round leaves more tokens behind; requirements that count them are fulfilled too early "
                        + "or never.",
                "Let a transition of the round take the tokens again, or let the edge not add them."));
    }

    @Override
    public List<DeepFinding> findings(Exploration found, DeepRequest request) {
        Plan plan = request.project().plan(request.plan()).orElseThrow();
        List<DeepFinding> findings = new ArrayList<>();
        piles(found).forEach(pile -> findings.add(finding(request, plan, pile)));
        return findings;
    }

    /** Those that need nobody's news, failures or buttons, the shortest first; one that holds another is the same once more. */
    private static List<PilesOfTokens.Pile> piles(Exploration found) {
        List<PilesOfTokens.Pile> told = new ArrayList<>();
        found.piles().all().stream()
                .filter(PilesOfTokens.Pile::byItself)
                .sorted(Comparator.comparingInt(pile -> pile.what().size()))
                .filter(pile -> told.stream().noneMatch(other -> pile.places().containsAll(other.places())))
                .limit(MOST)
                .forEach(told::add);
        return told;
    }

    private static DeepFinding finding(DeepRequest request, Plan plan, PilesOfTokens.Pile pile) {
        List<String> places = plan.places().stream()
                .map(place -> place.id())
                .filter(id -> pile.what().stream().anyMatch(what -> what.startsWith(id + " in " + plan.id() + ": ")))
                .toList();
        String where = places.isEmpty() ? "a sub-mission" : SearchWords.places(request, places);
        String message = "Tokens pile up in " + where + " of the plan \"" + plan.title() + "\""
                + SearchWords.when(request, pile.node().steps())
                + ": each round adds the same ones and nothing takes them away; take or consume them";
        Finding finding = Finding.warning(
                        CODE, SearchWords.pointer(request, plan), message, places.toArray(String[]::new))
                .inPlan(plan.id());
        return new DeepFinding(finding, Optional.of(pile.node().witness("piles up in " + where, request.robots())));
    }

    @Override
    public String result(Exploration found, DeepRequest request) {
        int count = piles(found).size();
        return count == 0 ? "nothing piles up" : "tokens pile up in " + count + (count == 1 ? " way" : " ways");
    }
}
