package org.sami.crw.operator;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.sami.crw.operator.mission.InterruptChoice;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Priority;

class InterruptModelTest {
    private final ModelWorld world = new ModelWorld();

    /** The project with another text in it. */
    private String changed(String from, String to) {
        String text = new ProjectWriter(ModelWorld.VOCABULARY).text(world.project);
        assertThat(text).contains(from);
        String changed = text.replace(from, to);
        Project project = new ProjectReader(ModelWorld.VOCABULARY).read(changed).orThrow();
        return new ProjectWriter(ModelWorld.VOCABULARY).text(project);
    }

    @Test
    void buttonsOfAMissionAreThoseOfThePlanWithWhichItStarted() {
        world.step(new Input.ProxyJoined("anna"), ModelWorld.start("first"));
        world.step(new Input.LoadProject(changed("There and back", "Another")), ModelWorld.start("second"));
        world.refresh();

        assertThat(world.models.interrupts().snapshot())
                .extracting(button -> button.mission() + " " + button.plan())
                .contains("1 There and back", "2 Another")
                .doesNotContain("1 Another");
    }

    @Test
    void whatMarkupSaysOfAButtonStandsOnIt() {
        String marked = changed(
                "\"fields\": {\"interruptName\": \"Over\"}",
                "\"fields\": {\"interruptName\": \"Over\"}, \"markups\": ["
                        + "{\"type\": \"Priority\", \"options\": {\"rank\": \"CRITICAL\"}}, "
                        + "{\"type\": \"Description\", \"options\": {\"source\": \"Ends it\"}}]");
        world.step(new Input.LoadProject(marked), ModelWorld.start("marked"));
        world.refresh();

        assertThat(world.models.interrupts().snapshot())
                .filteredOn(button -> button.name().equals("Over"))
                .singleElement()
                .satisfies(button -> assertThat(button.priority()).isEqualTo(Priority.CRITICAL))
                .satisfies(button -> assertThat(button.description()).isEqualTo("Ends it"));
        assertThat(world.models.interrupts().snapshot())
                .filteredOn(button -> button.name().equals("Go"))
                .extracting(InterruptChoice::priority)
                .containsExactly(Priority.MEDIUM);
    }
}
