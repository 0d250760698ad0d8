package org.sami.domain.mistake;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.edit.EdgeEdit;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EditSequence;
import org.sami.spn.edit.EventEdit;
import org.sami.spn.edit.FieldEdit;
import org.sami.spn.edit.RemoveElements;
import org.sami.spn.edit.VertexEdit;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.model.Mode;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Transition;
import org.sami.spn.model.WaitFor;
import org.sami.spn.testing.Requirements;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/** Edits of one plan, in few words. */
record PlanEdits(String plan) {
    static Edit all(Edit... edits) {
        return new EditSequence("Several", List.of(edits));
    }

    Edit in(String edge, String... requirements) {
        return new EdgeEdit.SetInRequirements(plan, edge, ins(requirements));
    }

    Edit out(String edge, String... requirements) {
        return new EdgeEdit.SetOutRequirements(plan, edge, outs(requirements));
    }

    Edit connectIn(String place, String transition, String... requirements) {
        return new EdgeEdit.ConnectIn(plan, place, transition, Mode.NOMINAL, ins(requirements));
    }

    Edit connectOut(String transition, String place, String... requirements) {
        return new EdgeEdit.ConnectOut(plan, transition, place, Mode.NOMINAL, outs(requirements));
    }

    private static List<InRequirement> ins(String... words) {
        return Arrays.stream(words).map(Requirements::in).toList();
    }

    private static List<OutRequirement> outs(String... words) {
        return Arrays.stream(words).map(Requirements::out).toList();
    }

    /** Leads an edge out of a transition to another place. */
    Edit redirect(String edge, String transition, String place, String... requirements) {
        return all(remove(edge), connectOut(transition, place, requirements));
    }

    Edit remove(String... elements) {
        return new RemoveElements(plan, Set.of(elements));
    }

    Edit set(String event, String field, Value value) {
        return new FieldEdit.SetField(plan, event, field, new FieldSource.Fixed(value));
    }

    Edit reads(String event, String field, String variable) {
        return new FieldEdit.SetField(plan, event, field, new FieldSource.FromVariable(variable));
    }

    Edit readsTask(String event, String field) {
        return new FieldEdit.SetField(plan, event, field, new FieldSource.FromTask());
    }

    Edit clear(String event, String field) {
        return new FieldEdit.ClearField(plan, event, field);
    }

    Edit button(String event, String name) {
        return new FieldEdit.SetInputField(plan, event, "interruptName", new TextValue(name));
    }

    /** An output event with fixed values. */
    Edit output(String place, String id, String type, Map<String, Value> values) {
        Map<String, FieldSource> fields = new LinkedHashMap<>();
        values.forEach((field, value) -> fields.put(field, new FieldSource.Fixed(value)));
        return new EventEdit.AddOutput(plan, place, new OutputEventSpec(id, type, fields, Map.of(), List.of()));
    }

    Edit outputOf(String place, String id, String type, Map<String, FieldSource> fields) {
        return new EventEdit.AddOutput(plan, place, new OutputEventSpec(id, type, fields, Map.of(), List.of()));
    }

    Edit input(String transition, String id, String type) {
        return new EventEdit.AddInput(plan, transition, new InputEventSpec(id, type, Map.of(), Map.of(), List.of()));
    }

    /** Lets a transition wait for another event. */
    Edit waitsFor(String event, String type) {
        return new EventEdit.ChangeInput(plan, new InputEventSpec(event, type, Map.of(), Map.of(), List.of()));
    }

    Edit markup(String event, MarkupSpec markup) {
        return new EventEdit.SetMarkup(plan, event, markup);
    }

    Edit place(String id) {
        return new VertexEdit.AddPlace(
                plan,
                new Place(id, id, false, false, false, Mode.NOMINAL, List.of(), List.of(), List.of()),
                Optional.empty());
    }

    Edit transition(String id) {
        return new VertexEdit.AddTransition(
                plan, new Transition(id, id, Mode.NOMINAL, WaitFor.EACH, List.of()), Optional.empty());
    }

    Edit end(String place, boolean end) {
        return new VertexEdit.SetEnd(plan, place, end, false);
    }
}
