package org.sami.spn.reference;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.value.PlanReference;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.Reserved;

/**
 * Draws the transitions of a random plan: most wait for what their place asks and move whom the answer names, as authors draw
 * them; some join any places, events and requirements.
 */
final class RandomTransitions {
    private static final List<String> NAME_NOBODY = List.of("Yes", "No", "Provided", "TimerExpired", "CheckReturn");

    private final Dice dice;
    /** For which sub-mission's return is checked; of its own, so that the rest of a seed's plan does not depend on it. */
    private final Dice naming;

    private final NetBuilder net;
    private final Sketch sketch;
    private final RandomRequirements requirements;
    /** Transitions out of each place. */
    private final Map<String, List<String>> outOf = new LinkedHashMap<>();
    /** How many of a hundred transitions are drawn without sense. */
    private final int senseless;

    /** Whether the transition at hand is to be one that is easily met: each place has one, so that tokens get on. */
    private boolean isPlain;

    private int transitions;

    RandomTransitions(Dice dice, NetBuilder net, Sketch sketch) {
        this.dice = dice;
        this.net = net;
        this.sketch = sketch;
        naming = new Dice(61L * sketch.places + sketch.outputs.hashCode());
        requirements = new RandomRequirements(dice, sketch.hasTasks);
        senseless = dice.chance(10) ? 100 : 12;
    }

    void draw() {
        for (int from = 0; from < sketch.inner(); from++) {
            isPlain = from == 0 || !dice.chance(senseless);
            draw(from);
            isPlain = false;
            int count = dice.below(3);
            for (int i = 0; i < count; i++) {
                draw(from);
            }
        }
        if (dice.chance(35)) {
            ofTheMission();
        }
        outOf.forEach((place, order) -> {
            if (order.size() > 1 && dice.chance(40)) {
                List<String> turned = new ArrayList<>(order);
                java.util.Collections.reverse(turned);
                net.order(place, turned.toArray(String[]::new));
            }
        });
    }

    private void draw(int from) {
        String place = Sketch.name(from);
        List<String> answers = answers(place);
        if (!isPlain && dice.chance(senseless)) {
            senseless(from);
        } else if (sketch.hasSub(place) && dice.chance(75)) {
            afterSubMission(from);
        } else if (!answers.isEmpty() && dice.chance(isPlain ? 100 : 75)) {
            onEvent(from, dice.pick(answers));
        } else if (from < sketch.places - 1 && dice.chance(answers.isEmpty() ? 50 : 8)) {
            silent(from);
        } else {
            onEvent(from, dice.pick("News", "News", "Other", "Interrupt", "Pose"));
        }
    }

    private String transition(String... places) {
        String t = "t" + transitions++;
        net.transition(t);
        for (String place : places) {
            outOf.computeIfAbsent(place, key -> new ArrayList<>()).add(t);
        }
        return t;
    }

    // ---- With sense

    /** Fires without an event: takes on what stands there. */
    private void silent(int from) {
        String place = Sketch.name(from);
        String kind = isPlain ? dice.pick("proxy", "any") : requirements.kind();
        String other = dice.chance(isPlain ? 5 : 50) ? anInnerPlace() : place;
        String t = other.equals(place) ? transition(place) : transition(place, other);
        net.in(place, t, dice.chance(15) ? "always" : wanting(kind));
        if (!other.equals(place)) {
            net.in(
                    other,
                    t,
                    dice.chance(80) ? requirements.inhibiting(requirements.kind()) : requirements.wanting(kind));
        }
        out(t, forward(from), requirements.moving(kind));
        if (dice.chance(25)) {
            out(t, forward(from), requirements.moving(dice.chance(50) ? kind : requirements.kind()));
        }
    }

    /** Waits for an answer or for news, and moves whom it names. */
    private void onEvent(int from, String event) {
        String place = Sketch.name(from);
        boolean isButton = event.endsWith("InterruptReceived");
        String other = dice.chance(isButton ? 85 : isPlain ? 5 : 35) ? anInnerPlace() : place;
        boolean hasOther = !other.equals(place);
        String t = hasOther ? transition(place, other) : transition(place);
        boolean isNamed = !NAME_NOBODY.contains(event) && !event.equals("GeneralInterruptReceived");
        input(t, event);
        if (dice.chance(isPlain ? 3 : 15) && !isButton) {
            input(t, event.equals("Other") ? "News" : "Other");
        }
        if (isNamed && dice.chance(isPlain ? 5 : 25)) {
            net.waitForAll(t);
        }
        String moved =
                isNamed && dice.chance(75) ? "relevant" : isPlain ? dice.pick("proxy", "any") : requirements.kind();
        net.in(place, t, hasOther && (isButton || dice.chance(40)) ? "always" : wanting(moved));
        if (hasOther) {
            net.in(
                    other,
                    t,
                    isButton
                            ? wanting(moved)
                            : dice.pick("always", wanting(moved), requirements.inhibiting(requirements.kind())));
        }
        moveOn(t, from, moved, List.of("GotAll", "Chosen", "Yes", "Picked").contains(event));
    }

    private String wanting(String moved) {
        if (dice.chance(20)) {
            return "always";
        }
        if (isPlain) {
            return moved + " >= 1";
        }
        return moved.equals("relevant") ? requirements.relevant() : requirements.wanting(moved);
    }

    /**
     * Draws the out edges.
     *
     * @param isAnsweredAtOnce whether the engine itself or autonomy answers: a ring of those would be a livelock
     */
    private void moveOn(String t, int from, String moved, boolean isAnsweredAtOnce) {
        String move = isPlain
                ? "take all " + moved
                : moved.equals("relevant") ? requirements.movingRelevant() : requirements.moving(moved);
        out(t, isAnsweredAtOnce ? forward(from) : anywhere(from), move);
        if (dice.chance(30)) {
            String second =
                    dice.pick(requirements.moving("generic"), requirements.moving(requirements.kind()), "always", move);
            out(t, isAnsweredAtOnce ? forward(from) : anywhere(from), second);
        }
    }

    /** Takes on what comes back from a sub-mission, by what it returned or how it ended. */
    private void afterSubMission(int from) {
        String place = Sketch.name(from);
        String t = transition(place);
        int die = isPlain ? 50 + dice.below(50) : dice.below(100);
        boolean isNamed = false;
        if (die < 35) {
            input(t, "CheckReturn");
            if (naming.chance(30)) { // of another return, or of the same
                Map<String, Value> second = Map.of(Reserved.VALUE, new TextValue(naming.pick("good", "bad")));
                net.input(t, "CheckReturn", second, Map.of());
            }
        } else if (die < 60) {
            input(t, dice.chance(60) && !sketch.twoAtOnce.contains(place) ? "SubMissionAborted" : "Interrupt");
            isNamed = true;
        } else if (die < 68) {
            input(t, "News");
            isNamed = true;
        }
        net.in(place, t, dice.chance(50) ? "always" : isNamed ? "relevant >= 1" : dice.pick("proxy >= 1", "any >= 1"));
        String move = isNamed && dice.chance(80)
                ? requirements.movingRelevant()
                : dice.chance(70) ? requirements.movingReturned() : requirements.moving(requirements.kind());
        out(t, anywhere(from), move);
        if (dice.chance(25)) {
            out(t, anywhere(from), dice.chance(50) ? requirements.movingReturned() : "add 1 generic");
        }
    }

    /** A button, news or an interception of the mission itself, mostly without in place. */
    private void ofTheMission() {
        String event = dice.pick("AbortReceived", "CompleteReceived", "Interrupt", "News");
        String place = anInnerPlace();
        boolean hasPlace = dice.chance(35);
        String t = hasPlace ? transition(place) : transition();
        input(t, event);
        if (hasPlace) {
            net.in(place, t, "always");
        }
        boolean toEnd = sketch.ends > 0 && dice.chance(60);
        int target = toEnd ? sketch.inner() + dice.below(sketch.ends) : dice.below(sketch.places);
        out(t, Sketch.name(target), dice.pick("take all any", "add 1 generic", "add all relevant", "take all proxy"));
    }

    // ---- Without

    private void senseless(int from) {
        String place = Sketch.name(from);
        String other = dice.chance(35) ? anInnerPlace() : place;
        List<String> in = other.equals(place) || (sketch.hasSub(place) && sketch.hasSub(other))
                ? List.of(place)
                : List.of(place, other);
        List<String> events = anyEvents(in);
        String t = transition(in.toArray(String[]::new));
        events.forEach(event -> input(t, event));
        boolean isNamed = !events.isEmpty();
        if (isNamed && dice.chance(15)) {
            net.waitForAll(t);
        }
        for (String p : in) {
            boolean free = in.size() > 1 && dice.chance(35);
            net.in(p, t, free ? new String[] {"always"} : requirements.anyIn(isNamed, sketch.hasSub(p)));
        }
        int outs = dice.chance(70) ? 1 : dice.chance(70) ? 2 : 0;
        for (int i = 0; i < outs; i++) {
            String to = events.isEmpty() && dice.chance(92) ? forward(from) : anywhere(from);
            out(t, to, requirements.anyOut(isNamed, in.stream().anyMatch(sketch::hasSub)));
        }
    }

    private List<String> anyEvents(List<String> in) {
        List<String> answers = new ArrayList<>();
        for (String place : in) {
            answers.addAll(answers(place));
            if (sketch.hasSub(place)) {
                answers.add("CheckReturn");
                if (!sketch.twoAtOnce.contains(place)) {
                    answers.add("SubMissionAborted");
                }
            }
        }
        if (dice.chance(25)) {
            return List.of();
        }
        List<String> events = new ArrayList<>();
        if (!answers.isEmpty() && dice.chance(80)) {
            events.add(dice.pick(answers));
        } else {
            events.add(dice.pick("News", "News", "Interrupt", "Pose", "AbortReceived", "CompleteReceived"));
        }
        if (dice.chance(12)) {
            String second = answers.isEmpty() || dice.chance(50) ? "Other" : dice.pick(answers);
            if (!events.contains(second)) {
                events.add(second);
            }
        }
        return events;
    }

    // ---- Events

    private List<String> answers(String place) {
        List<String> answers = new ArrayList<>();
        sketch.outputs.get(place).forEach(type -> answers.addAll(answersTo(type)));
        return answers;
    }

    private static List<String> answersTo(String type) {
        return switch (type) {
            case "Do" -> List.of("Done", "Done", "Done2");
            case "Approve" -> List.of("Yes", "No");
            case "ApproveThem" -> List.of("YesThem", "NoThem");
            case "Choose", "ChooseSome" -> List.of("Chosen");
            case "Pick" -> List.of("Picked", "PickedNone");
            case "Provide" -> List.of("Provided");
            case "StartTimer" -> List.of("TimerExpired");
            case "StartProxyTimer" -> List.of("ProxyTimerExpired");
            case "GetAll" -> List.of("GotAll");
            case "GeneralInterrupt" -> List.of("GeneralInterruptReceived");
            case "ProxyInterrupt" -> List.of("ProxyInterruptReceived");
            default -> List.of();
        };
    }

    private void input(String t, String event) {
        Map<String, Value> fields = switch (event) {
            case "Interrupt" -> Map.of("interruptName", new TextValue(dice.pick("stop", "hold")));
            case "CheckReturn" -> checked(new TextValue(dice.pick("good", "good", "bad")));
            default -> Map.of();
        };
        Map<String, String> writes = switch (event) {
            case "Done", "Done2", "News", "Other" ->
                dice.chance(35) ? Map.of("value", RandomPlans.variable(dice)) : Map.of();
            case "Provided" -> dice.chance(60) ? Map.of("number", RandomPlans.variable(dice)) : Map.of();
            default -> Map.of();
        };
        net.input(t, event, fields, writes);
    }

    /** A return of any sub-mission, or of one: mostly of one that may stand on the place. */
    private Map<String, Value> checked(Value value) {
        if (sketch.children.isEmpty() || naming.chance(55)) {
            return Map.of(Reserved.VALUE, value);
        }
        return Map.of(Reserved.VALUE, value, Reserved.SUB_MISSION, new PlanReference(naming.pick(sketch.children)));
    }

    // ---- Places

    private void out(String t, String place, String... words) {
        net.out(t, place, words);
    }

    private String anInnerPlace() {
        return Sketch.name(dice.below(Math.max(1, sketch.inner())));
    }

    /** One of the next places: rings without events are rare. */
    private String forward(int from) {
        int target = dice.chance(97) ? from + 1 + dice.below(2) : dice.below(sketch.places);
        return Sketch.name(Math.min(target, sketch.places - 1));
    }

    /** Mostly a place from which it goes on; children come to their ends sooner. */
    private String anywhere(int from) {
        if (dice.chance(sketch.isChild ? 60 : 35)) {
            return forward(from);
        }
        return dice.chance(85) ? anInnerPlace() : Sketch.name(dice.below(sketch.places));
    }
}
