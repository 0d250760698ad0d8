package org.sami.spn.statespace;

import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.sami.spn.model.Plan;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.naming.ElementNames;
import org.sami.spn.protocol.Token;

/** Words for what searches find. */
final class SearchWords {
    private SearchWords() {}

    /** A place of the plan that is searched: its name in quotes, else what it does. */
    static String place(DeepRequest request, String id) {
        return plan(request).place(id).map(names(request)::inSentence).orElse("\"" + id + "\"");
    }

    /** A transition of the plan that is searched: its name in quotes, else what it waits for. */
    static String transition(DeepRequest request, String id) {
        return plan(request).transition(id).map(names(request)::inSentence).orElse("\"" + id + "\"");
    }

    static String places(DeepRequest request, List<String> ids) {
        return ids.stream().map(id -> place(request, id)).collect(Collectors.joining(", "));
    }

    static ElementNames names(DeepRequest request) {
        return new ElementNames(plan(request), request.vocabulary());
    }

    private static Plan plan(DeepRequest request) {
        return request.project().plan(request.plan()).orElseThrow();
    }

    static String tokens(List<Token> tokens) {
        return tokens.stream().map(SearchWords::token).distinct().collect(Collectors.joining(", "));
    }

    static String token(Token token) {
        if (token instanceof Token.Proxy proxy) {
            return proxy.proxy();
        }
        return token instanceof Token.Task task ? "the task " + task.task().name() : "a generic token";
    }

    /** Whether other plans run the plan: then it ends for each who enters, and what they bring is not tried. */
    static boolean isSubMission(DeepRequest request) {
        return uses(request).findAny().isPresent();
    }

    /** Whether other plans share one run of it: then others may enter at any time. */
    static boolean isShared(DeepRequest request) {
        return uses(request).anyMatch(SubMissionSpec::shared);
    }

    private static Stream<SubMissionSpec> uses(DeepRequest request) {
        return request.project().plans().stream()
                .flatMap(plan -> plan.places().stream())
                .flatMap(place -> place.subMissions().stream())
                .filter(sub -> sub.plan().equals(request.plan()));
    }

    static String pointer(DeepRequest request, Plan plan) {
        return "/plans/" + request.project().plans().indexOf(plan);
    }

    static String robots(DeepRequest request) {
        int robots = request.robots().size();
        return robots == 1 ? "1 robot" : robots + " robots";
    }

    /** Where in a run something shows. */
    static String when(DeepRequest request, int steps) {
        return " (" + (steps == 1 ? "1 step" : steps + " steps") + " from the start, " + robots(request) + ")";
    }

    /** How far a search came; a result follows. */
    static String looked(Exploration found, DeepRequest request) {
        String looked = found.looked() + " states with " + robots(request);
        return found.isComplete() ? "All " + looked + " were looked at: " : "Of the first " + looked + ", ";
    }

    /** What was not looked at; empty text where all was. */
    static String rest(Exploration found) {
        String rest = "";
        if (found.isOutOfMemory()) {
            rest = "; the memory for more is used up";
        } else if (!found.piles().all().isEmpty()) {
            rest = "; ways on which tokens pile up were not followed further";
        } else if (!found.isComplete()) {
            rest = "; there are more that were not looked at";
        }
        return found.unlooked().isEmpty() ? rest : rest + "; not looked at: " + String.join("; ", found.unlooked());
    }
}
