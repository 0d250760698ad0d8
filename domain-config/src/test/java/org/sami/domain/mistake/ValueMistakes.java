package org.sami.domain.mistake;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.sami.spn.edit.Edit;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/** Mistakes in what stands in fields, and in where their values come from. */
final class ValueMistakes {
    private static final PlanEdits CLV = new PlanEdits("clv");
    private static final PlanEdits EXPLORE = new PlanEdits("explore-area");
    private static final PlanEdits PANORAMA = new PlanEdits("panorama");
    private static final PlanEdits HOME = new PlanEdits("bring-home");

    private ValueMistakes() {}

    private static AuthorMistake of(String name, String plan, String code, String element, Edit edit) {
        return AuthorMistake.of(name, plan, code, element, edit);
    }

    static List<AuthorMistake> all() {
        List<AuthorMistake> all = new ArrayList<>();
        addNumbers(all);
        addPlaces(all);
        addWords(all);
        addSources(all);
        return all;
    }

    private static void addNumbers(List<AuthorMistake> all) {
        all.add(of(
                "battery levels as fractions, not percent",
                RightPlans.WATCHED,
                "W-FRACTION",
                "explore",
                PlanEdits.all(EXPLORE.set("levels", "low", real(0.3)), EXPLORE.set("levels", "critical", real(0.15)))));
        all.add(of(
                "low level below the critical one",
                RightPlans.WATCHED,
                "W-NOT-ABOVE",
                "explore",
                EXPLORE.set("levels", "low", real(10))));
        all.add(of(
                "more than 100 %",
                RightPlans.WATCHED, "E-OUT-OF-RANGE", "explore", EXPLORE.set("levels", "low", real(130))));
        all.add(of(
                "negative speed",
                "bring-home",
                "E-OUT-OF-RANGE",
                "go",
                HOME.output("go", "slow", "SetVelocityMultiplier", Map.of("multiplier", real(-1)))));
        PlanEdits recharge = new PlanEdits("recharge");
        all.add(of(
                "spacing of nothing",
                "recharge",
                "E-OUT-OF-RANGE",
                "find",
                recharge.set("ask-berths", "spacing", real(0))));
        all.add(of(
                "negative spacing",
                "explore-area",
                "E-OUT-OF-RANGE",
                "explore",
                EXPLORE.set("go", "spacing", real(-50))));
        all.add(of(
                "lanes 5 km apart",
                "explore-area",
                "W-UNUSUAL-VALUE",
                "explore",
                EXPLORE.set("go", "spacing", real(5000))));
        all.add(of(
                "timer of 0 s",
                "panorama",
                "W-UNUSUAL-VALUE",
                "rest",
                PANORAMA.set("rest-timer", "duration", new DurationValue(0))));
    }

    private static void addPlaces(List<AuthorMistake> all) {
        GeoPoint near = GeoPoint.of(45.6, 10.68);
        GeoPoint beside = GeoPoint.of(45.601, 10.681);
        all.add(of(
                "latitude and longitude swapped",
                "clv",
                "W-SWAPPED",
                "ask-allocation",
                CLV.set(
                        "ask-allocation",
                        "locations",
                        new ListValue(List.of(near, beside, GeoPoint.of(10.68, 45.6))))));
        all.add(of(
                "a location in another town",
                "clv",
                "W-FAR-AWAY",
                "ask-allocation",
                CLV.set(
                        "ask-allocation",
                        "locations",
                        new ListValue(List.of(near, beside, GeoPoint.of(45.9, 10.68))))));
        GeoPath far = new GeoPath(List.of(near, GeoPoint.of(45.62, 10.68), near));
        all.add(of(
                "a path longer than a charge",
                "clv",
                "W-BEYOND-RANGE",
                "go",
                CLV.set("go", "paths", new MapValue(Map.of(new ProxyValue("b1"), far)))));
        PlanEdits home = new PlanEdits("bring-home");
        all.add(of(
                "a boat that is not there",
                RightPlans.KATARA + "bring-home",
                "W-UNKNOWN-ROBOT",
                "go",
                home.set("goto", "points", new MapValue(Map.of(new ProxyValue("ambar"), GeoPoint.of(25.36, 51.529))))));
    }

    private static void addWords(List<AuthorMistake> all) {
        all.add(of(
                "a sensor that no boat has",
                RightPlans.SAMPLED,
                "W-UNKNOWN-WORD",
                "panorama",
                PANORAMA.set("read", "sensor", text("oxigen"))));
        all.add(of(
                "an empty question",
                "explore-area",
                "W-EMPTY-QUESTION",
                "wait",
                EXPLORE.set("ask-clear", "question", text(" "))));
        all.add(of(
                "a button without a name",
                "explore-area",
                "W-EMPTY-QUESTION",
                "somebody-passes",
                EXPLORE.button("let-pass", "")));
        all.add(of(
                "a class of tasks that is not there",
                "panorama",
                "E-UNKNOWN-TASK",
                "make-tasks",
                PANORAMA.set("make-tasks", "taskClass", text("Photo"))));
    }

    private static void addSources(List<AuthorMistake> all) {
        all.add(of("a field left empty", "explore-area", "E-FIELD-MISSING", "go", EXPLORE.clear("go", "area")));
        all.add(of("wrong variable type", "clv", "E-VARIABLE-TYPE", "go", CLV.reads("go", "paths", "@locations")));
        all.add(of("a misspelt variable", "clv", "E-VARIABLE-UNKNOWN", "go", CLV.reads("go", "paths", "@pahts")));
        all.add(of(
                "options applied, not the chosen one",
                "panorama",
                "E-VARIABLE-TYPE",
                "apply-it",
                PANORAMA.reads("apply-it", "allocation", "@allocations")));
        all.add(of(
                "nothing to apply",
                "panorama",
                "E-APPLIES-NOTHING",
                "apply-it",
                PANORAMA.clear("apply-it", "allocation")));
        all.add(of(
                "an allocation applied before one is chosen",
                "panorama",
                "W-NOT-YET-WRITTEN",
                "apply-it",
                PANORAMA.redirect("allocated.choose", "allocated", "apply", "take all any")));
        all.add(of(
                "paths that nobody chose",
                "clv",
                "W-NOT-YET-WRITTEN",
                "go",
                CLV.redirect(
                        "locations-created.allocate",
                        "locations-created",
                        "execute",
                        "take all proxy",
                        "take 1 generic")));
        all.add(of(
                "the chosen paths not kept",
                "clv",
                "W-VARIABLE-NEVER-WRITTEN",
                "@paths",
                CLV.waitsFor("yes", "OperatorAcceptedAllocation")));
        all.add(of(
                "task in the wrong field",
                "panorama",
                "E-TASK-FIELD",
                "rest",
                PANORAMA.readsTask("rest-timer", "duration")));
        all.add(of(
                "autonomy answers after no time",
                "bring-home",
                "E-NO-TIMEOUT",
                "select",
                HOME.markup(
                        "ask-boats",
                        new MarkupSpec(
                                "MixedInitiativeTrigger", Map.of("trigger", new EnumValue("Trigger", "TIMER"))))));
        all.add(of(
                "autonomy is to draw",
                "panorama",
                "E-DRAWN-BY-AUTONOMY",
                "locations",
                PANORAMA.markup(
                        "ask-locations",
                        new MarkupSpec(
                                "MixedInitiativeTrigger",
                                Map.of("trigger", new EnumValue("Trigger", "IMMEDIATELY"))))));
    }

    private static Value real(double number) {
        return new RealValue(number);
    }

    private static Value text(String text) {
        return new TextValue(text);
    }
}
