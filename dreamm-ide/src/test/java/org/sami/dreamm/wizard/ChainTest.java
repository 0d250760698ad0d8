package org.sami.dreamm.wizard;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.dreamm.profile.Profile;
import org.sami.spn.edit.EditResult;
import org.sami.spn.edit.PlanBuilder;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.wizard.AddEvent;
import org.sami.spn.wizard.EventTarget;

/** Events that are added one after another, with nothing clicked in between, make a chain. */
class ChainTest {
    private static final DomainLibrary BOATS =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();

    private final DreammContext context = new DreammContext(
            BOATS,
            new ProjectDocument(
                    BOATS.vocabulary(),
                    new Project("mine", "", "crw", List.of(), List.of(), List.of(new PlanBuilder("p").build())),
                    Optional.empty()),
            Profile.ALL);

    @AfterEach
    void close() {
        context.close();
    }

    private Plan plan() {
        return context.editor().plan().orElseThrow();
    }

    private void add(String event) {
        Additions additions = context.additions();
        assertThat(additions.add(
                        AddEvent.usual("p", event, additions.target(true), additions.mode(), additions.library())))
                .isInstanceOf(EditResult.Done.class);
    }

    private Place place(String event) {
        return plan().places().stream()
                .filter(place -> place.outputs().stream().anyMatch(o -> o.type().equals(event)))
                .findFirst()
                .orElseThrow();
    }

    @Test
    void eachGoesOnAtTheBlankPlaceThatTheOneBeforeHasLeft() {
        add("OperatorSelectBoatList");
        add("AssembleLocationRequest");
        add("ProxyGotoPoint");

        assertThat(place("AssembleLocationRequest")).isNotEqualTo(place("OperatorSelectBoatList"));
        assertThat(plan().places()).filteredOn(p -> p.outputs().size() > 1).isEmpty();
        assertThat(plan().places()).filteredOn(p -> p.outputs().size() == 1).hasSize(3);
        assertThat(context.editor().selection())
                .as("its fields are in the inspector")
                .containsExactly(place("ProxyGotoPoint").id());
    }

    @Test
    void whatIsClickedIsWhereTheNextOneGoes() {
        add("OperatorSelectBoatList");
        String first = place("OperatorSelectBoatList").id();

        context.additions().leaveChain();

        assertThat(context.additions().target(true)).isEqualTo(new EventTarget.OnVertex(first));
    }

    @Test
    void whatIsSelectedOtherwiseIsWhereTheNextOneGoes() {
        add("OperatorSelectBoatList");
        String transition = plan().transitions().get(0).id();
        context.editor().select(List.of(transition));

        assertThat(context.additions().target(true)).isEqualTo(new EventTarget.Behind(transition));
    }
}
