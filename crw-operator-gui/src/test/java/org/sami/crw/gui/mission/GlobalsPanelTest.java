package org.sami.crw.gui.mission;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.EventThreadCall.onEventThread;
import static org.sami.crw.gui.SessionWorld.laidOut;
import static org.sami.crw.gui.SessionWorld.rows;
import static org.sami.crw.gui.SessionWorld.text;
import static org.sami.crw.gui.SessionWorld.type;
import static org.sami.crw.gui.SessionWorld.until;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.gui.SessionWorld;
import org.sami.crw.gui.context.LoadedProject;
import org.sami.spn.engine.EngineView;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.model.Project;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.Value;

@Timeout(900)
class GlobalsPanelTest {
    private static final Project PROJECT = SessionWorld.project("""
            {'formatVersion': 1, 'id': 'lake', 'name': 'Lake', 'domain': 'crw',
             'globals': [{'name': '@home', 'type': 'point'}, {'name': '@spacing', 'type': 'real', 'initial': 5}],
             'missionTree': [{'label': 'All', 'children': [{'plan': 'reads'}]}],
             'plans': [
              {'id': 'reads', 'name': 'Reads', 'reads': ['@spacing'], 'places': [
                {'id': 'say', 'name': 'Say', 'start': true}],
               'transitions': [], 'inEdges': [], 'outEdges': []}
             ]}""");

    @TempDir
    private Path folder;

    @Test
    void aNewValueCountsAtOnceForTheMissionsThatReadIt() throws Exception {
        try (SessionWorld world = new SessionWorld(PROJECT)) {
            GlobalsPanel panel = panel(world, Optional.empty());
            world.start("reads");
            select(panel, "@spacing");
            until("its reader is named", () -> text(panel, "global-about").contains("Reads (1)"));
            assertThat(world.whyNot("global-set")).isEqualTo("@spacing has this value already");
            assertThat(world.whyNot("globals-save")).isNotEmpty();

            type(panel, "value-global-spacing-text", "wide");
            assertThat(text(panel, "global-problem")).isNotEmpty();
            assertThat(world.whyNot("global-set")).isNotEmpty();

            type(panel, "value-global-spacing-text", "7.5");
            world.run("global-set");

            until("it is listed as changed", () -> rows(panel, "globals-table").contains("@spacing|● 7.5"));
            assertThat(SessionWorld.get(world.session.ask(EngineView::globals)))
                    .containsEntry("@spacing", new RealValue(7.5));
        }
    }

    @Test
    void valuesGoToTheProjectsFileOnRequest() throws Exception {
        Path file = folder.resolve("lake.json");
        try (SessionWorld world = new SessionWorld(PROJECT)) {
            GlobalsPanel panel = panel(world, Optional.empty());
            set(world, panel, "7.5");
            onEventThread(() -> {
                panel.save(file);
                return null;
            });
            until("nothing is left to save", () -> !world.whyNot("globals-save").isEmpty());
            assertThat(initial(file)).contains(new RealValue(7.5));

            set(world, panel, "9");
            world.run("globals-save");
            until("nothing is left to save", () -> !world.whyNot("globals-save").isEmpty());
            assertThat(initial(file)).contains(new RealValue(9));
            assertThat(Files.readString(file)).contains("\"reads\"");
        }
    }

    @Test
    void whatIsFilledInStaysWhileAnotherVariableIsShown() throws Exception {
        try (SessionWorld world = new SessionWorld(PROJECT)) {
            GlobalsPanel panel = panel(world, Optional.empty());
            select(panel, "@spacing");
            type(panel, "value-global-spacing-text", "7.5");

            select(panel, "@home");
            until(
                    "the list says so",
                    () -> rows(panel, "globals-table").contains("@spacing|5.0, filled in and not set"));
            assertThat(world.whyNot("globals-save"))
                    .isEqualTo("what is filled in for @spacing is not set yet: set the variable first");

            select(panel, "@spacing");
            assertThat(text(panel, "value-global-spacing-text")).isEqualTo("7.5");
            world.run("global-set");
            until("it is set", () -> rows(panel, "globals-table").contains("@spacing|● 7.5\n"));
        }
    }

    @Test
    void savingSaysWhatItLeavesOutAsItIsNotSet() throws Exception {
        Path file = folder.resolve("lake.json");
        List<String> told = new ArrayList<>();
        try (SessionWorld world = new SessionWorld(PROJECT)) {
            GlobalsPanel panel = panel(world, Optional.empty());
            onEventThread(() -> {
                world.context.notices().addListener(notice -> told.add(notice.text()));
                return null;
            });
            set(world, panel, "7.5");
            select(panel, "@home");
            type(panel, "value-global-home-text", "45.4, 10.9");
            select(panel, "@spacing");
            onEventThread(() -> {
                panel.save(file);
                return null;
            });

            until("it is saved", () -> told.stream().anyMatch(text -> text.contains(file.toString())));
            assertThat(onEventThread(() -> told.get(told.size() - 1)))
                    .endsWith("; not saved: what is filled in for @home and not set");
            assertThat(initial(file)).contains(new RealValue(7.5));
        }
    }

    private static GlobalsPanel panel(SessionWorld world, Optional<Path> file) {
        GlobalsPanel panel = laidOut(() -> new GlobalsPanel(world.context, world.editors(), new LoadedProject(file)));
        until("globals are listed", () -> rows(panel, "globals-table").contains("@spacing|"));
        return panel;
    }

    private static void select(GlobalsPanel panel, String name) {
        onEventThread(() -> {
            panel.select(name);
            return null;
        });
    }

    private static void set(SessionWorld world, GlobalsPanel panel, String text) {
        select(panel, "@spacing");
        type(panel, "value-global-spacing-text", text);
        world.run("global-set");
        until("it can be saved", () -> world.whyNot("globals-save").isEmpty());
    }

    private static Optional<Value> initial(Path file) {
        return new ProjectReader(SessionWorld.LIBRARY.vocabulary())
                .read(file).orThrow().globals().stream()
                        .filter(global -> global.name().equals("@spacing"))
                        .findFirst()
                        .flatMap(VariableSpec::initial);
    }
}
