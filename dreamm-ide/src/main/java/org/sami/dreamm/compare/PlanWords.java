package org.sami.dreamm.compare;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.model.VariableSpec;

/** The differences of two versions of a plan outside of their nets. */
final class PlanWords {
    private PlanWords() {}

    static List<String> differences(Plan was, Plan is) {
        List<String> texts = new ArrayList<>();
        if (!was.name().equals(is.name())) {
            texts.add("The plan's name was \"" + was.name() + "\"");
        }
        if (!was.description().equals(is.description())) {
            texts.add("The plan's description is another");
        }
        parts("variable ", was.variables(), is.variables(), VariableSpec::name, texts);
        parts("task ", was.tasks(), is.tasks(), TaskSpec::name, texts);
        if (!was.reads().equals(is.reads())) {
            texts.add("The plan expects other variables of its parents");
        }
        if (!was.notes().equals(is.notes())) {
            texts.add("The plan's notes are others");
        }
        if (!was.frames().equals(is.frames())) {
            texts.add("The plan's frames are others");
        }
        return texts;
    }

    static List<String> casesAndQueries(Plan was, Plan is) {
        List<String> texts = new ArrayList<>();
        parts("test case ", was.testCases(), is.testCases(), one -> "\"" + one.name() + "\"", texts);
        parts("query ", was.queries(), is.queries(), one -> "\"" + one.name() + "\"", texts);
        return texts;
    }

    private static <T> void parts(String kind, List<T> was, List<T> is, Function<T, String> name, List<String> texts) {
        Map<String, T> earlier = new LinkedHashMap<>();
        was.forEach(each -> earlier.put(name.apply(each), each));
        for (T each : is) {
            T old = earlier.remove(name.apply(each));
            if (old == null) {
                texts.add("The " + kind + name.apply(each) + " is new");
            } else if (!old.equals(each)) {
                texts.add("The " + kind + name.apply(each) + " is another");
            }
        }
        earlier.values().forEach(each -> texts.add("The " + kind + name.apply(each) + " is gone"));
    }
}
