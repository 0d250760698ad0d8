package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.handler.EventCatalogue.Seen;
import org.sami.crw.service.Geodesy;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/** Tasks: made, allocated, started one after another, passed on, complete (appendix .2, Tasks; docs/language.md). */
final class TaskEventCases {
    private static final GeoPoint NEAR = PlanScene.at(0, 20);
    private static final GeoPoint FAR = PlanScene.at(0, 60);
    private static final double REACHED_M = 4;

    private TaskEventCases() {}

    static void add(EventCatalogue catalogue) {
        making(catalogue);
        allocating(catalogue);
        moving(catalogue);
        ending(catalogue);
    }

    private static void making(EventCatalogue catalogue) {
        catalogue
                .shows(
                        "GenerateTasks",
                        Seen.IN_THE_MARKING,
                        "there is one task for each location, with its class and location",
                        TaskEventCases::generate)
                .shows(
                        "TasksGenerated",
                        Seen.IN_THE_MARKING,
                        "the tokens of the new tasks enter the mission",
                        TaskEventCases::generate);
    }

    private static void generate() {
        PlanScene scene = new PlanScene(
                new PlanSketch()
                        .asks(
                                "make",
                                "GenerateTasks",
                                "locations",
                                new ListValue(List.of(NEAR, FAR)),
                                "taskClass",
                                new TextValue("Camera"))
                        .joining("make", "TasksGenerated", "made"),
                0);
        assertThat(scene.marking(PlanScene.MISSION, "made")).containsExactly(task("Camera 1"), task("Camera 2"));
        Optional<Map<String, Value>> second = scene.world.host.ask(view -> view.task(id("Camera 2")));
        assertThat(second.orElseThrow()).containsEntry("location", FAR);
    }

    private static void allocating(EventCatalogue catalogue) {
        catalogue.shows(
                "ApplyAllocation",
                Seen.ON_A_BOAT,
                "the boat to which a task is allocated goes to the task's location",
                () -> {
                    PlanScene scene = working(1, allocation("near", "boat-1"));
                    scene.untilTask("near", "done");
                    assertThat(Geodesy.distanceM(scene.world.hull("boat-1").position(), NEAR))
                            .isLessThan(REACHED_M);
                });
        catalogue.shows(
                "TaskStarted",
                Seen.ON_A_BOAT,
                "a boat does its tasks one after another, in the order of the allocation",
                () -> {
                    PlanScene scene = working(1, allocation("far", "boat-1", "near", "boat-1"));
                    scene.untilTask("far", "go");
                    assertThat(scene.stands(task("near"), "work")).isTrue();
                    scene.untilTask("far", "done");
                    assertThat(Geodesy.distanceM(scene.world.hull("boat-1").position(), FAR))
                            .isLessThan(REACHED_M);
                    scene.untilTask("near", "done");
                    assertThat(scene.used("TaskStarted"))
                            .extracting(occurrence -> occurrence.tasks().get(0).name())
                            .containsExactly("far", "near");
                });
        catalogue.shows(
                "RefreshTasks",
                Seen.IN_THE_MARKING,
                "a task that was started before its token came is said to be started once more; one that waits is not",
                () -> {
                    PlanScene scene = new PlanScene(
                            tasks().asks("here", "OperatorApprove")
                                    .on("here", "YesOption", "refresh", "any-token")
                                    .asks("refresh", "RefreshTasks")
                                    .on("refresh", "TaskStarted", "go"),
                            1);
                    scene.post(new Input.AllocateTasks(boats("near", "boat-1", "far", "boat-1")));
                    assertThat(scene.marking(PlanScene.MISSION, "go")).isEmpty();
                    scene.answer(new Answer.YesNo(true));
                    scene.untilTask("near", "go");
                    assertThat(scene.stands(task("far"), "refresh")).isTrue();
                    startedOnceAtATime();
                });
    }

    /** A boat that begins with the task just then, and one that has begun with it before. */
    private static void startedOnceAtATime() {
        PlanScene scene = new PlanScene(
                tasks().asks("allot", "ApplyAllocation", "tasks", allocation("near", "boat-1"))
                        .on("allot", "", "work", "any-token")
                        .asks("work", "RefreshTasks")
                        .on("work", "TaskStarted", "go")
                        .asks("go", "OperatorApprove")
                        .on("go", "YesOption", "allot", "any-token"),
                1);
        scene.untilTask("near", "go");
        assertThat(scene.notes()).noneMatch(note -> note.contains("TaskStarted"));
        scene.answer(new Answer.YesNo(true));
        scene.untilTask("near", "go");
        assertThat(scene.used("TaskStarted")).hasSize(2);
        assertThat(scene.notes()).noneMatch(note -> note.contains("TaskStarted"));
    }

    private static void moving(EventCatalogue catalogue) {
        catalogue.shows(
                "TaskDelayed",
                Seen.IN_THE_MARKING,
                "a task that another one overtakes in its boat's queue goes back, and is started again in its turn",
                () -> {
                    PlanScene scene = working(1, allocation("near", "boat-1"));
                    scene.untilTask("near", "go");
                    scene.post(new Input.AllocateTasks(boats("far", "boat-1", "near", "boat-1")));
                    scene.untilTask("near", "work").untilTask("far", "go");
                    scene.untilTask("far", "done").untilTask("near", "done");
                    assertThat(scene.used("TaskDelayed")).hasSize(1);
                });
        catalogue.shows(
                "TaskReassigned",
                Seen.ON_A_BOAT,
                "a task that another boat gets is done by that boat, and the first one stops",
                () -> {
                    PlanScene scene = working(2, allocation("far", "boat-1"));
                    scene.untilTask("far", "go");
                    scene.run(3);
                    assertThat(scene.world.hull("boat-1").isAtRest()).isFalse();
                    scene.post(new Input.AllocateTasks(boats("far", "boat-2")));
                    assertThat(scene.used("TaskReassigned").get(0).proxies()).containsExactly("boat-2");
                    scene.untilTask("far", "done");
                    assertThat(Geodesy.distanceM(scene.world.hull("boat-2").position(), FAR))
                            .isLessThan(REACHED_M);
                    assertThat(scene.world.hull("boat-1").isAtRest()).isTrue();
                    assertThat(Geodesy.distanceM(scene.world.hull("boat-1").position(), FAR))
                            .isGreaterThan(20);
                });
        catalogue.shows(
                "TaskReleased",
                Seen.IN_THE_MARKING,
                "the boat that had the task is named when it has it no longer",
                () -> {
                    PlanScene scene = released("TaskReleased");
                    scene.untilTask("far", "told");
                    assertThat(scene.used("TaskReleased").get(0).proxies()).containsExactly("boat-1");
                });
        catalogue.shows(
                "TaskUnassigned", Seen.IN_THE_MARKING, "a task whose boat is dropped has none, and says so", () -> {
                    PlanScene scene = released("TaskUnassigned");
                    scene.untilTask("far", "told");
                    Map<TaskId, String> left = scene.world.host.ask(view -> view.allocation());
                    assertThat(left).doesNotContainKey(id("far"));
                });
    }

    private static PlanScene released(String news) {
        PlanScene scene = new PlanScene(
                tasks().asks("here", "ApplyAllocation", "tasks", allocation("far", "boat-1"))
                        .on("here", news, "told"),
                2);
        scene.post(new Input.ProxyDropped("boat-1", Ids.NONE));
        return scene;
    }

    private static void ending(EventCatalogue catalogue) {
        catalogue.shows(
                "TaskComplete",
                Seen.ON_A_BOAT,
                "the boat is free of the task and begins with its next one; the task is not said to be released",
                () -> {
                    PlanScene scene = working(1, allocation("near", "boat-1", "far", "boat-1"));
                    scene.untilTask("near", "done");
                    assertThat(scene.world.domain.tasks().of("boat-1").tasks()).containsExactly(id("far"));
                    scene.untilTask("far", "done");
                    assertThat(scene.world.domain.tasks().of("boat-1").tasks()).isEmpty();
                    assertThat(scene.used("TaskUnassigned")).isEmpty();
                });
        catalogue.shows("TaskCompleted", Seen.IN_THE_MARKING, "the task moves on, its boat is named", () -> {
            PlanScene scene = working(2, allocation("near", "boat-2"));
            scene.untilTask("near", "done");
            assertThat(scene.used("TaskCompleted").get(0).proxies()).containsExactly("boat-2");
            assertThat(scene.stands(task("far"), "work")).isTrue();
        });
    }

    /** A plan in which each task is gone to when it is started, and complete when its boat has arrived. */
    private static PlanScene working(int boats, MapValue allocation) {
        return new PlanScene(
                tasks().asks("allot", "ApplyAllocation", "tasks", allocation)
                        .on("allot", "", "work", "any-token")
                        .on("work", "TaskStarted", "go")
                        .asks("go", "ProxyGotoLatLon", "location", "@task")
                        .on("go", "ProxyPathCompleted", "there")
                        .on("go", "TaskDelayed", "work")
                        .on("go", "TaskReassigned", "work")
                        .on("go", "TaskUnassigned", "lost")
                        .asks("there", "TaskComplete")
                        .on("there", "TaskCompleted", "done"),
                boats);
    }

    private static PlanSketch tasks() {
        return new PlanSketch().task("near", NEAR).task("far", FAR);
    }

    private static MapValue allocation(String... pairs) {
        Map<Value, Value> entries = new LinkedHashMap<>();
        for (int i = 0; i < pairs.length; i += 2) {
            entries.put(id(pairs[i]), new ProxyValue(pairs[i + 1]));
        }
        return new MapValue(entries);
    }

    private static Map<TaskId, Optional<String>> boats(String... pairs) {
        Map<TaskId, Optional<String>> boats = new LinkedHashMap<>();
        for (int i = 0; i < pairs.length; i += 2) {
            boats.put(id(pairs[i]), Optional.of(pairs[i + 1]));
        }
        return boats;
    }

    private static TaskId id(String name) {
        return new TaskId(PlanScene.MISSION, name);
    }

    private static Token task(String name) {
        return new Token.Task(id(name));
    }
}
