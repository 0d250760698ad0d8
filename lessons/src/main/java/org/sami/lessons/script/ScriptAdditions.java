package org.sami.lessons.script;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.RenameElement;
import org.sami.spn.edit.VertexEdit;
import org.sami.spn.finding.Suggestions;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.Mode;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.Transition;
import org.sami.spn.sequence.AuthoringLibrary;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.Vocabulary;
import org.sami.spn.wiring.Wires;
import org.sami.spn.wizard.AddEvent;
import org.sami.spn.wizard.AddVertex;
import org.sami.spn.wizard.EventTarget;
import org.sami.spn.wizard.PaletteIds;

/** Makes the edits that add items of the palette, with the ids that a script gives what they make. */
final class ScriptAdditions {
    private final Vocabulary vocabulary;
    private final AuthoringLibrary library;

    ScriptAdditions(Vocabulary vocabulary, AuthoringLibrary library) {
        this.vocabulary = vocabulary;
        this.library = library;
    }

    Edit edit(ScriptElement.Add add, Project project, Plan plan) throws ScriptRefusedException {
        EventTarget target = new EventTarget.Free(add.at());
        if (add.on().isPresent()) {
            new PlanIds(plan).vertex(add.on().get(), "/on");
            target = new EventTarget.OnVertex(add.on().get());
        }
        Edit edit = bare(add, project, plan, target);
        Plan drawn = Tried.plan(edit, project, plan.id(), vocabulary);
        return NamedEdit.of(edit, names(add, edit, plan, drawn));
    }

    private Edit bare(ScriptElement.Add add, Project project, Plan plan, EventTarget target)
            throws ScriptRefusedException {
        Optional<EventType> event = vocabulary.events().values().stream()
                .filter(type -> PaletteIds.event(type).equals(add.item()))
                .findFirst();
        if (event.isPresent()) {
            AddEvent usual = AddEvent.usual(plan.id(), event.get().name(), target, Mode.NOMINAL, library)
                    .withWires(Wires.NONE);
            return add.sequence().map(usual::withSequence).orElse(usual);
        }
        AddVertex.Content content = content(add.item(), project);
        boolean runsPlan = content instanceof AddVertex.Content.SubMission;
        if (add.sequence().isPresent() || (add.event().isPresent() && !runsPlan)) {
            throw new ScriptRefusedException(
                    "", "\"sequence\" and \"event\" go with an event: " + add.item() + " is none");
        }
        return new AddVertex(plan.id(), content, target, Mode.NOMINAL, library);
    }

    private AddVertex.Content content(String item, Project project) throws ScriptRefusedException {
        if (item.equals(PaletteIds.BLANK_PLACE)) {
            return new AddVertex.Content.BlankPlace();
        }
        if (item.equals(PaletteIds.BLANK_TRANSITION)) {
            return new AddVertex.Content.BlankTransition();
        }
        for (Plan runs : project.plans()) {
            if (PaletteIds.subMission(runs.id()).equals(item)) {
                return new AddVertex.Content.SubMission(runs.id(), runs.title());
            }
        }
        List<String> known = new ArrayList<>(List.of(PaletteIds.BLANK_PLACE, PaletteIds.BLANK_TRANSITION));
        vocabulary.events().values().forEach(type -> known.add(PaletteIds.event(type)));
        project.plans().forEach(p -> known.add(PaletteIds.subMission(p.id())));
        throw new ScriptRefusedException(
                "/item", "The palette has no item \"" + item + "\"" + Suggestions.meant(known, item));
    }

    /** The edits that give the new vertex and its event the ids and the name of the script. */
    private List<Edit> names(ScriptElement.Add add, Edit edit, Plan before, Plan drawn) throws ScriptRefusedException {
        Made made = made(edit, before, drawn);
        List<Edit> names = new ArrayList<>();
        Optional<String> eventId = add.on().isPresent() ? add.id() : add.event();
        eventId.ifPresent(id -> names.add(new RenameElement(before.id(), made.event.orElseThrow(), id)));
        if (add.on().isPresent()) {
            return names;
        }
        String vertex = made.vertex.orElseThrow(
                () -> new ScriptRefusedException("", "The sequence draws no vertex with " + add.item()));
        add.name().ifPresent(name -> names.add(new VertexEdit.NameVertex(before.id(), vertex, name)));
        add.id().ifPresent(id -> names.add(new RenameElement(before.id(), vertex, id)));
        return names;
    }

    /**
     * What an edit has made.
     *
     * @param vertex that is new and stands for the item
     * @param event or sub-mission that is new and stands for the item
     */
    private record Made(Optional<String> vertex, Optional<String> event) {}

    private Made made(Edit edit, Plan before, Plan drawn) {
        Set<String> old = before.elementIds();
        if (edit instanceof AddEvent added) {
            boolean output = vocabulary
                    .event(added.event())
                    .filter(t -> t.direction() == Direction.OUTPUT)
                    .isPresent();
            return output ? output(added.event(), old, drawn) : input(added.event(), old, drawn);
        }
        Optional<Place> place =
                drawn.places().stream().filter(p -> !old.contains(p.id())).findFirst();
        Optional<String> transition = drawn.transitions().stream()
                .map(Transition::id)
                .filter(id -> !old.contains(id))
                .findFirst();
        Optional<String> sub = drawn.places().stream()
                .flatMap(p -> p.subMissions().stream())
                .map(SubMissionSpec::id)
                .filter(id -> !old.contains(id))
                .findFirst();
        return new Made(place.map(Place::id).or(() -> transition), sub);
    }

    private static Made output(String type, Set<String> old, Plan drawn) {
        for (Place place : drawn.places()) {
            Optional<String> event = place.outputs().stream()
                    .filter(o -> o.type().equals(type) && !old.contains(o.id()))
                    .map(OutputEventSpec::id)
                    .findFirst();
            if (event.isPresent()) {
                return new Made(Optional.of(place.id()).filter(id -> !old.contains(id)), event);
            }
        }
        return new Made(Optional.empty(), Optional.empty());
    }

    private static Made input(String type, Set<String> old, Plan drawn) {
        for (Transition transition : drawn.transitions()) {
            Optional<String> event = transition.inputs().stream()
                    .filter(i -> i.type().equals(type) && !old.contains(i.id()))
                    .map(InputEventSpec::id)
                    .findFirst();
            if (event.isPresent()) {
                return new Made(Optional.of(transition.id()).filter(id -> !old.contains(id)), event);
            }
        }
        return new Made(Optional.empty(), Optional.empty());
    }
}
