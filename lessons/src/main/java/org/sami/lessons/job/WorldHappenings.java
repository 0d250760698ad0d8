package org.sami.lessons.job;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.InterruptButton;
import org.sami.spn.model.TestStep;
import org.sami.spn.protocol.Activation;
import org.sami.spn.stepping.Stepper;
import org.sami.spn.stepping.TakenStep;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.EventFlag;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.Vocabulary;

/** What happens in a hidden case without being an answer: robots that connect, interrupts, news. */
final class WorldHappenings {
    private static final long MOST_NEW_ROBOTS = 20;

    private final Stepper stepper;
    private final JobCase job;
    private final WorldTrace trace;

    WorldHappenings(Stepper stepper, JobCase job, WorldTrace trace) {
        this.stepper = stepper;
        this.job = job;
        this.trace = trace;
    }

    private EngineView view() {
        return stepper.view();
    }

    private Vocabulary vocabulary() {
        return view().vocabulary();
    }

    private EventType type(String name) {
        return vocabulary().event(name).orElseThrow();
    }

    /** The robots that are named, or the next that nobody knows, connect. */
    List<TakenStep> connect(Asked asked, Optional<JobCase.Reaction> reaction) {
        Activation activation = asked.activation().orElseThrow();
        List<TakenStep> taken = new ArrayList<>();
        List<String> robots = new ArrayList<>();
        String name = name(activation);
        long count = activation.value("numberToCreate").orElse(null) instanceof IntegerValue number
                ? Math.min(number.value(), MOST_NEW_ROBOTS)
                : 1;
        for (int i = 0; i < count; i++) {
            String robot = i == 0 && !name.isBlank() ? name : RobotNames.next(view().proxies());
            if (!view().proxies().contains(robot)) {
                taken.add(stepper.take(new TestStep.Join(robot)));
            }
            robots.add(robot);
        }
        String said = reaction.map(JobCase.Reaction::answer).orElse("");
        List<String> types = said.isEmpty() ? type(asked.type()).answers() : List.of(said);
        String type = types.stream().filter(view()::awaits).findFirst().orElse(types.get(0));
        trace.answered(stepper.nowMillis(), type, robots, List.of());
        taken.add(stepper.occur(activation.id(), type, robots, List.of(), Map.of()));
        return taken;
    }

    private static String name(Activation activation) {
        for (Value value : activation.values().values()) {
            if (value instanceof RecordValue record && record.field("name").orElse(null) instanceof TextValue text) {
                return text.value();
            }
        }
        return activation.value("name").orElse(null) instanceof TextValue text ? text.value() : "";
    }

    /** Something of the script happens. */
    List<TakenStep> happen(JobCase.What what) {
        if (what instanceof JobCase.What.Press press) {
            String name = view().interrupts().stream()
                    .map(InterruptButton::name)
                    .filter(press.interrupt()::equalsIgnoreCase)
                    .findFirst()
                    .orElse(press.interrupt());
            return List.of(stepper.take(new TestStep.Press(name, press.robots())));
        } else if (what instanceof JobCase.What.Drop drop) {
            return List.of(stepper.take(new TestStep.Drop(drop.robot())));
        } else if (what instanceof JobCase.What.Join join) {
            List<TakenStep> taken = new ArrayList<>(List.of(stepper.take(new TestStep.Join(join.robot()))));
            if (view().awaits("ProxyCreated")) {
                taken.add(stepper.news("ProxyCreated", List.of(join.robot()), List.of(), Map.of()));
            }
            return taken;
        }
        return List.of(news((JobCase.What.News) what));
    }

    /** News; what is no news answers the request that is open. */
    private TakenStep news(JobCase.What.News news) {
        EventType type = type(news.type());
        List<TaskId> tasks = news.tasks().stream()
                .flatMap(number -> trace.task(number).stream())
                .toList();
        Map<String, Value> values =
                WorldValues.asked(news.type(), view(), job.locations()).fields(type, news.values());
        trace.answered(stepper.nowMillis(), type.name(), news.robots(), news.tasks());
        Optional<Activation> asked = view().openActivations().stream()
                .filter(one -> type(one.type()).answers().contains(type.name())
                        && one.proxies().containsAll(news.robots())
                        && one.tasks().containsAll(tasks))
                .findFirst();
        return asked.isEmpty() || type.flags().contains(EventFlag.NEWS)
                ? stepper.news(type.name(), news.robots(), tasks, values)
                : stepper.occur(asked.get().id(), type.name(), news.robots(), tasks, values);
    }

    /** News of tasks that some transition waits for; in each mission by the task's name there. */
    List<TakenStep> tell(TaskNewsWatch.News news) {
        List<TakenStep> taken = new ArrayList<>();
        if (vocabulary().event(news.type()).isPresent() && view().awaits(news.type())) {
            for (TaskId name : view().namesOf(news.task())) {
                taken.add(stepper.news(news.type(), news.robots(), List.of(name), Map.of()));
            }
        }
        return taken;
    }
}
