package org.sami.crw.console;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.crw.operator.mission.BlockedPlaces;
import org.sami.crw.operator.mission.EngineText;
import org.sami.crw.operator.mission.InterruptChoice;
import org.sami.crw.operator.mission.MissionSnapshot;
import org.sami.crw.operator.mission.Wait;
import org.sami.crw.sim.run.settings.Parameters;
import org.sami.spn.model.DisabledParts;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.Value;

/** Commands that start, show and end missions. */
final class MissionCommands {
    private final ConsoleContext context;

    MissionCommands(ConsoleContext context) {
        this.context = context;
    }

    List<ConsoleCommand> all() {
        return List.of(
                ConsoleCommand.of("plans", "Lists the plans and what each asks at its start.", this::plans),
                ConsoleCommand.of(
                        "start PLAN [NAME=VALUE ...]",
                        "Starts a mission; values by event.field, field or @variable.",
                        this::start,
                        this::startWords),
                ConsoleCommand.of("missions", "Lists the missions and where their tokens are.", this::missions),
                ConsoleCommand.of(
                        "why MISSION|BOAT",
                        "Says what a mission waits for, or why a boat moves or does not.",
                        this::why,
                        words -> words.size() > 1 ? List.of() : missionsAndBoats()),
                ConsoleCommand.of(
                        "abort MISSION|all",
                        "Aborts a mission: its boats stop doing what it asked.",
                        this::abort,
                        words -> words.size() > 1 ? List.of() : plus(context.missions(), "all")),
                ConsoleCommand.of(
                        "complete MISSION",
                        "Completes a mission.",
                        this::complete,
                        words -> words.size() > 1 ? List.of() : context.missions()),
                ConsoleCommand.of(
                        "again MISSION",
                        "Sends again what failed in a mission that is stuck.",
                        this::again,
                        words -> words.size() > 1 ? List.of() : context.missions()),
                ConsoleCommand.of("interrupts", "Lists the interrupts that missions offer.", this::interrupts),
                ConsoleCommand.of(
                        "press NAME [BOAT ...] [in MISSION]",
                        "Presses an interrupt, of every mission that offers it or of one.",
                        this::press,
                        this::pressWords));
    }

    private static List<String> plus(List<String> words, String more) {
        List<String> all = new ArrayList<>(words);
        all.add(more);
        return all;
    }

    private List<String> missionsAndBoats() {
        List<String> all = new ArrayList<>(context.missions());
        all.addAll(context.boats());
        return all;
    }

    private void plans(Arguments arguments, Consumer<String> out) {
        arguments.end();
        for (Plan plan : context.project().plans()) {
            out.accept(plan.id() + (plan.name().isEmpty() ? "" : "  " + plan.name()));
            for (Parameters.Description parameter : parameters(plan).describe()) {
                String preset = parameter.preset().map(value -> " = " + value).orElse("");
                out.accept("  " + parameter.name() + "  " + parameter.type() + preset);
            }
        }
    }

    private Parameters parameters(Plan plan) {
        return new Parameters(context.vocabulary(), context.project(), plan);
    }

    private List<String> startWords(List<String> words) {
        if (words.size() <= 1) {
            return context.plans();
        }
        return context.project()
                .plan(words.get(0))
                .map(plan -> parameters(plan).describe().stream()
                        .filter(Parameters.Description::editable)
                        .map(parameter -> parameter.name() + "=")
                        .toList())
                .orElse(List.of());
    }

    private void start(Arguments arguments, Consumer<String> out) {
        Plan plan = context.plan(arguments.next("plan"));
        Map<String, String> texts = new LinkedHashMap<>();
        for (String word : arguments.rest()) {
            int equals = word.indexOf('=');
            if (equals < 1) {
                throw new ConsoleFault("a value is given as NAME=VALUE, not '" + word + "'");
            }
            texts.put(word.substring(0, equals), word.substring(equals + 1));
        }
        Map<String, Value> values;
        try {
            values = parameters(plan).read(texts);
        } catch (IllegalArgumentException unfit) {
            throw new ConsoleFault(String.valueOf(unfit.getMessage()));
        }
        long mission = context.await(context.session().start(plan.id(), plan.title(), values));
        out.accept("mission " + mission + " of " + plan.id() + " has begun" + DisabledParts.remark(plan));
    }

    private void missions(Arguments arguments, Consumer<String> out) {
        arguments.end();
        List<MissionSnapshot> all = context.models().missions().snapshot().missions();
        if (all.isEmpty()) {
            out.accept("no mission has begun; start one with: start PLAN");
        }
        String runs =
                context.models().health().snapshot().missionsStandStill() ? "stands still, runs since " : "runs since ";
        for (MissionSnapshot mission : all) {
            String state = mission.outcome()
                    .map(outcome -> outcome.name().toLowerCase(Locale.ROOT) + " at "
                            + Numbers.clock(mission.endedAtMillis().orElse(0)))
                    .orElse(runs + Numbers.clock(mission.startedAtMillis()));
            String of = mission.parent() == Ids.NONE ? "" : " in mission " + mission.parent();
            out.accept(
                    mission.id() + "  " + mission.plan() + of + "  " + state + ", " + mission.firings() + " firings");
            mission.stuck()
                    .filter(stuck -> mission.parent() == Ids.NONE)
                    .ifPresent(stuck -> out.accept("    stuck since " + Numbers.clock(stuck.sinceMillis()) + ": "
                            + stuck.what() + ". " + stuck.help()
                            + (stuck.canBeSentAgain() ? " (again " + mission.id() + ")." : ".")));
            if (!mission.hasEnded()) {
                mission.marking()
                        .forEach((place, tokens) -> out.accept("    " + place(mission, place) + ": " + words(tokens)));
                mission.visitedByNobody().forEach(place -> out.accept("    " + place(mission, place) + ": nobody"));
            }
        }
    }

    private String place(MissionSnapshot mission, String place) {
        return context.project()
                .plan(mission.plan())
                .flatMap(plan -> plan.place(place))
                .map(Place::name)
                .filter(name -> !name.isEmpty())
                .orElse(place);
    }

    private static String words(List<Token> tokens) {
        return String.join(", ", tokens.stream().map(EngineText::token).toList());
    }

    private void why(Arguments arguments, Consumer<String> out) {
        String who = arguments.next("mission or boat");
        arguments.end();
        Optional<Long> mission = number(who);
        if (mission.isEmpty()) {
            out.accept(context.words()
                    .say(context.await(context.session().fleet().why(who)).text()));
            return;
        }
        Optional<List<Wait>> waits = context.await(context.session()
                .ask(view -> view.mission(mission.get())
                        .map(running -> BlockedPlaces.of(context.vocabulary(), view, running))));
        List<Wait> known = waits.orElseThrow(() -> new ConsoleFault("no mission " + who + " runs"));
        if (known.isEmpty()) {
            out.accept("mission " + who + " waits for nothing");
        }
        known.forEach(wait -> wait.lines().forEach(out));
    }

    private static Optional<Long> number(String word) {
        return word.matches("\\d{1,18}") ? Optional.of(Long.parseLong(word)) : Optional.empty();
    }

    private void abort(Arguments arguments, Consumer<String> out) {
        if (arguments.peek().equals("all")) {
            arguments.next("mission");
            arguments.end();
            context.await(context.session().abortAll());
            out.accept("all missions are aborted");
            return;
        }
        long mission = arguments.number("mission");
        arguments.end();
        context.await(context.session().abort(mission));
        out.accept("mission " + mission + " is asked to abort");
    }

    private void complete(Arguments arguments, Consumer<String> out) {
        long mission = arguments.number("mission");
        arguments.end();
        context.await(context.session().complete(mission));
        out.accept("mission " + mission + " is asked to complete");
    }

    private void again(Arguments arguments, Consumer<String> out) {
        long mission = arguments.number("mission");
        arguments.end();
        context.await(context.session().sendAgain(mission));
        out.accept("what failed in mission " + mission + " is sent again");
    }

    private void interrupts(Arguments arguments, Consumer<String> out) {
        arguments.end();
        List<InterruptChoice> choices = context.models().interrupts().snapshot();
        if (choices.isEmpty()) {
            out.accept("no running mission offers an interrupt");
        }
        for (InterruptChoice choice : choices) {
            String who = choice.asksForBoats() ? ", for " + context.words().typed("boats") : "";
            String state = choice.isEnabled() ? "can be pressed" : choice.whyNot();
            out.accept(choice.name() + "  mission " + choice.mission() + who + ": " + state);
        }
    }

    private List<String> pressWords(List<String> words) {
        return words.size() <= 1
                ? context.models().interrupts().snapshot().stream()
                        .map(InterruptChoice::name)
                        .distinct()
                        .toList()
                : plus(context.boats(), "in");
    }

    private void press(Arguments arguments, Consumer<String> out) {
        String name = arguments.next("interrupt");
        List<String> boats = new ArrayList<>();
        long mission = Ids.NONE;
        while (arguments.hasNext()) {
            if (arguments.peek().equals("in")) {
                arguments.next("in");
                mission = arguments.number("mission");
                arguments.end();
            } else {
                boats.add(arguments.next("boat"));
            }
        }
        List<String> known = context.models().interrupts().snapshot().stream()
                .map(InterruptChoice::name)
                .distinct()
                .toList();
        if (!known.contains(name)) {
            throw new ConsoleFault("no running mission has an interrupt '" + name + "'"
                    + (known.isEmpty() ? "" : "; there are " + String.join(", ", known)));
        }
        context.await(context.session().press(name, mission, boats));
        out.accept("pressed " + name + (boats.isEmpty() ? "" : " for " + String.join(", ", boats)));
    }
}
