package org.sami.crw.console;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.crw.operator.OperatorLogEntry;
import org.sami.crw.operator.OperatorModels;
import org.sami.crw.operator.alarm.Alarm;
import org.sami.crw.operator.boat.Age;
import org.sami.crw.operator.boat.BoatCommunication;
import org.sami.crw.operator.health.Health;
import org.sami.crw.operator.mission.AllocationSnapshot;
import org.sami.crw.sim.run.settings.ValueText;
import org.sami.spn.finding.Finding;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;

/** Commands about how things stand: alarms, communication, who has which tasks, and the operator's log. */
final class SituationCommands {
    /** What stands before the number of an alarm, to tell it from a message's. */
    private static final String ALARM = "a";

    private static final String NOBODY = "nobody";

    private final ConsoleContext context;

    SituationCommands(ConsoleContext context) {
        this.context = context;
    }

    List<ConsoleCommand> all() {
        return List.of(
                ConsoleCommand.of(
                        "health",
                        "Lists every fault that lasts, the worst first: since when, and what to do.",
                        this::health),
                ConsoleCommand.of("alarms", "Lists what is wrong with boats, the worst first.", this::alarms),
                ConsoleCommand.of(
                        "ack NUMBER|aNUMBER|all",
                        "Acknowledges a message, an alarm, or all of both.",
                        this::acknowledge,
                        words -> alarmNumbers()),
                ConsoleCommand.of(
                        "mute aNUMBER [off]",
                        "Mutes alarms of this kind about this boat, or has them heard again.",
                        this::mute,
                        words -> words.size() > 1 ? List.of("off") : alarmNumbers()),
                ConsoleCommand.of(
                        "comm",
                        "Lists how boats stand in their missions and their links, the worst first.",
                        this::communication),
                ConsoleCommand.of("allocation", "Lists who has which tasks.", this::allocation),
                ConsoleCommand.of(
                        "move TASK BOAT|nobody",
                        "Gives a task, MISSION/NAME, to another boat, or to nobody.",
                        this::move,
                        words -> words.size() > 1
                                ? boatsAndNobody()
                                : tasks().stream().map(SituationCommands::name).toList()),
                ConsoleCommand.of("log", "Lists what operators did and noted in this session.", this::log),
                ConsoleCommand.of(
                        "note TEXT [at LAT,LON]",
                        "Writes a note into the operator's log, maybe about a place.",
                        this::note));
    }

    private OperatorModels models() {
        return context.models();
    }

    // ---- health and alarms

    private void health(Arguments arguments, Consumer<String> out) {
        arguments.end();
        Health health = models().health().snapshot();
        if (health.isWell()) {
            out.accept("no fault");
        }
        health.entries()
                .forEach(entry -> out.accept(lower(entry.severity()) + "  "
                        + entry.fault().text() + "  since " + Numbers.clock(entry.sinceMillis()) + "  to do: "
                        + entry.fault().advice()
                        + (entry.fault().details().isEmpty()
                                ? ""
                                : "  details: " + entry.fault().details())));
    }

    private void alarms(Arguments arguments, Consumer<String> out) {
        arguments.end();
        List<Alarm> alarms = models().alarms().snapshot();
        if (alarms.isEmpty()) {
            out.accept("no alarm");
        }
        for (Alarm alarm : alarms) {
            out.accept(ALARM + alarm.number() + "  "
                    + lower(alarm.kind().severity()) + "  " + alarm.text() + "  since "
                    + Numbers.clock(alarm.sinceMillis()) + (alarm.active() ? "" : ", over")
                    + (alarm.acknowledged() ? ", acknowledged" : "") + (alarm.muted() ? ", muted" : ""));
        }
    }

    private List<String> alarmNumbers() {
        return models().alarms().snapshot().stream()
                .map(alarm -> ALARM + alarm.number())
                .toList();
    }

    private Alarm alarm(String word) {
        return models().alarms().snapshot().stream()
                .filter(alarm -> word.equals(ALARM + alarm.number()))
                .findFirst()
                .orElseThrow(() -> new ConsoleFault("there is no alarm '" + word + "'; 'alarms' lists them"));
    }

    private void acknowledge(Arguments arguments, Consumer<String> out) {
        String what = arguments.next("number");
        arguments.end();
        if (what.equals("all")) {
            models().messages().snapshot().forEach(entry -> models().messages().acknowledge(entry.number()));
            models().alarms().snapshot().forEach(alarm -> models().alarms().acknowledge(alarm.number()));
            out.accept("all messages and alarms are acknowledged");
        } else if (what.startsWith(ALARM)) {
            models().alarms().acknowledge(alarm(what).number());
            out.accept("alarm " + what + " is acknowledged");
        } else {
            long number = models().messages().snapshot().stream()
                    .map(entry -> entry.number())
                    .filter(one -> String.valueOf(one).equals(what))
                    .findFirst()
                    .orElseThrow(() -> new ConsoleFault("there is no message " + what));
            models().messages().acknowledge(number);
            out.accept("message " + number + " is acknowledged");
        }
    }

    private void mute(Arguments arguments, Consumer<String> out) {
        Alarm alarm = alarm(arguments.next("alarm"));
        boolean mute = !arguments.hasNext();
        if (!mute && !arguments.next("word").equals("off")) {
            throw new ConsoleFault("an alarm is heard again by: mute " + ALARM + alarm.number() + " off");
        }
        arguments.end();
        models().alarms().mute(alarm.kind(), alarm.boat(), mute);
        String kind = lower(alarm.kind()).replace('_', ' ');
        out.accept("alarms of " + kind + " about " + alarm.boat() + (mute ? " make no sound" : " are heard again"));
    }

    // ---- communication

    private void communication(Arguments arguments, Consumer<String> out) {
        arguments.end();
        List<BoatCommunication> boats = models().communication().snapshot();
        if (boats.isEmpty()) {
            out.accept(context.words().say("there is no boat"));
        }
        long now = context.session().nowMillis();
        boats.forEach(boat -> out.accept(boat.boat() + "  " + lower(boat.status()) + "  link " + lower(boat.link())
                + (boat.heardAtMillis().isEmpty()
                        ? ""
                        : " " + Age.words(now - boat.heardAtMillis().getAsLong()))
                + String.join(
                        "",
                        boat.missions().stream()
                                .map(one -> "  mission " + one.mission() + " " + lower(one.status()) + " since "
                                        + Numbers.clock(one.sinceMillis()))
                                .toList())));
    }

    // ---- tasks

    private void allocation(Arguments arguments, Consumer<String> out) {
        arguments.end();
        AllocationSnapshot allocation = models().allocation().snapshot();
        if (allocation.queues().isEmpty() && allocation.unallocated().isEmpty()) {
            out.accept("no mission has tasks");
        }
        allocation.queues().forEach((boat, tasks) -> out.accept(boat + ": " + names(tasks)));
        if (!allocation.unallocated().isEmpty()) {
            out.accept(NOBODY + ": " + names(allocation.unallocated()));
        }
    }

    private static String names(List<TaskId> tasks) {
        return String.join(", ", tasks.stream().map(SituationCommands::name).toList());
    }

    private static String name(TaskId task) {
        return task.mission() + "/" + task.name();
    }

    private List<TaskId> tasks() {
        AllocationSnapshot allocation = models().allocation().snapshot();
        List<TaskId> tasks = new ArrayList<>(allocation.unallocated());
        allocation.queues().values().forEach(tasks::addAll);
        return tasks;
    }

    private List<String> boatsAndNobody() {
        List<String> all = new ArrayList<>(context.boats());
        all.add(NOBODY);
        return all;
    }

    private void move(Arguments arguments, Consumer<String> out) {
        String word = arguments.next("task");
        String boat = arguments.next("boat");
        arguments.end();
        TaskId task = tasks().stream()
                .filter(one -> name(one).equals(word))
                .findFirst()
                .orElseThrow(() -> new ConsoleFault("there is no open task '" + word + "'"
                        + (tasks().isEmpty() ? "" : "; there are " + names(tasks()))));
        context.await(context.session().moveTask(task, Optional.of(boat).filter(one -> !one.equals(NOBODY))));
        out.accept(word + " is " + boat + "'s now");
    }

    // ---- the log

    private void log(Arguments arguments, Consumer<String> out) {
        arguments.end();
        List<OperatorLogEntry> entries = models().log().snapshot();
        if (entries.isEmpty()) {
            out.accept("nothing was done yet; actions and notes appear here");
        }
        entries.forEach(entry -> out.accept(entry.number() + "  " + Numbers.clock(entry.atMillis()) + "  "
                + context.words().say(lower(entry.kind())).replace('_', ' ') + "  " + entry.text()
                + entry.position().map(at -> "  at " + text(at)).orElse("")));
    }

    private static String text(GeoPoint at) {
        return String.format(Locale.ROOT, "%.5f,%.5f", at.latDeg(), at.lonDeg());
    }

    private void note(Arguments arguments, Consumer<String> out) {
        List<String> words = new ArrayList<>(List.of(arguments.next("text")));
        words.addAll(arguments.rest());
        Optional<GeoPoint> position = Optional.empty();
        if (words.size() > 2 && words.get(words.size() - 2).equals("at")) {
            position = point(words.get(words.size() - 1));
            if (position.isPresent()) {
                words = words.subList(0, words.size() - 2);
            }
        }
        context.await(context.session().addNote(String.join(" ", words), position));
        out.accept("noted" + position.map(at -> " at " + text(at)).orElse(""));
    }

    /** A place, or just a word of the note. */
    private Optional<GeoPoint> point(String word) {
        List<Finding> findings = new ArrayList<>();
        Optional<Value> value = ValueText.parse(
                word, ValueType.Simple.POINT, context.vocabulary().types(), findings);
        return value.filter(GeoPoint.class::isInstance).map(GeoPoint.class::cast);
    }

    private static String lower(Enum<?> constant) {
        return constant.name().toLowerCase(Locale.ROOT);
    }
}
