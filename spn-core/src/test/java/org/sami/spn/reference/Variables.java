package org.sami.spn.reference;

import java.util.Optional;
import org.sami.spn.model.Project;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.value.TypeCheck;
import org.sami.spn.value.Value;

/** Reading and writing variables (R-VAR-1 to R-VAR-3). */
final class Variables {
    private final World world;

    Variables(World world) {
        this.world = world;
    }

    /** Reads a variable (R-VAR-1). */
    Optional<Value> read(Mission m, String variable) {
        String mapped = m.asChild.map(i -> i.spec.variables().get(variable)).orElse(null);
        if (mapped != null) {
            return read(m.parent().orElseThrow(), mapped);
        }
        if (declares(m, variable) || m.variables.containsKey(variable)) {
            return Optional.ofNullable(m.variables.get(variable));
        }
        return m.parent()
                .map(parent -> read(parent, variable))
                .orElseGet(() -> global(m.project, variable).map(v -> world.globals.get(variable)));
    }

    /** Writes a variable (R-VAR-2). */
    void write(Mission m, String variable, Value value) {
        boolean fits = declaration(m, variable)
                .map(v -> TypeCheck.accepts(v.type(), value, world.vocabulary.types()))
                .orElse(true);
        if (!fits) { // R-VAR-3
            world.note(NoteKind.REJECTED_INPUT, m.id, variable);
        } else if (!writeWhereDeclared(m, variable, value)) {
            m.variables.put(variable, value);
            world.effects.add(new Effect.VariableWritten(m.id, variable, value));
        }
    }

    private boolean writeWhereDeclared(Mission m, String variable, Value value) {
        String mapped = m.asChild.map(i -> i.spec.variables().get(variable)).orElse(null);
        if (mapped != null) {
            write(m.parent().orElseThrow(), mapped, value);
            return true;
        }
        if (declares(m, variable)) {
            m.variables.put(variable, value);
            world.effects.add(new Effect.VariableWritten(m.id, variable, value));
            return true;
        }
        if (m.parent().isPresent()) {
            return writeWhereDeclared(m.parent().get(), variable, value);
        }
        return writeGlobal(m.project, variable, value);
    }

    boolean writeGlobal(Project project, String variable, Value value) {
        boolean declared = global(project, variable).isPresent();
        if (declared) {
            world.globals.put(variable, value);
            world.effects.add(new Effect.VariableWritten(Ids.NONE, variable, value));
        }
        return declared;
    }

    private static boolean declares(Mission m, String variable) {
        return m.plan.variables().stream().anyMatch(v -> v.name().equals(variable));
    }

    /** The declaration that a read or write of this mission means. */
    Optional<VariableSpec> declaration(Mission m, String variable) {
        String mapped = m.asChild.map(i -> i.spec.variables().get(variable)).orElse(null);
        if (mapped != null) {
            return declaration(m.parent().orElseThrow(), mapped);
        }
        Optional<VariableSpec> own = m.plan.variables().stream()
                .filter(v -> v.name().equals(variable))
                .findFirst();
        if (own.isPresent()) {
            return own;
        }
        return m.parent().map(parent -> declaration(parent, variable)).orElseGet(() -> global(m.project, variable));
    }

    static Optional<VariableSpec> global(Project project, String variable) {
        return project.globals().stream().filter(v -> v.name().equals(variable)).findFirst();
    }
}
