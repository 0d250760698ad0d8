package org.sami.session.person;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.boat.link.security.OwnerOnlyFile;

/**
 * The people of a session in a file that only its user can read. It has no keys, only their hashes. Each operation reads or writes the whole file; a
 * killed process leaves the old or the new one.
 */
public final class PeopleFile implements People {
    private static final ObjectMapper JSON = new ObjectMapper();
    private static final int VERSION = 1;

    private final Path file;

    /** People in a file, which need not exist yet. */
    public PeopleFile(Path file) {
        this.file = file;
    }

    /** The file. */
    public Path file() {
        return file;
    }

    /**
     * Everybody, in the order in which they were added.
     *
     * @throws IOException if the file is damaged, cannot be read, or may be read by others
     */
    public synchronized List<Person> all() throws IOException {
        if (!Files.exists(file)) {
            return List.of();
        }
        try {
            JsonNode root = JSON.readTree(new String(OwnerOnlyFile.read(file), StandardCharsets.UTF_8));
            if (root.path("version").asInt() != VERSION) {
                throw new IOException(file + " is no list of people of version " + VERSION);
            }
            List<Person> people = new ArrayList<>();
            for (JsonNode one : root.path("people")) {
                List<String> decisions = new ArrayList<>();
                one.path("decisions").forEach(type -> decisions.add(type.asText()));
                String role = one.path("role").asText();
                people.add(new Person(
                        one.path("name").asText(),
                        PersonRole.of(role)
                                .orElseThrow(() -> new IllegalArgumentException("'" + role + "' is no role")),
                        decisions,
                        one.path("key").asText()));
            }
            return List.copyOf(people);
        } catch (JsonProcessingException | IllegalArgumentException damaged) {
            throw new IOException(file + " cannot be read: " + damaged.getMessage(), damaged);
        }
    }

    /**
     * Adds somebody.
     *
     * @throws IllegalArgumentException in words, if the name is taken
     * @throws IOException if the file cannot be read or written
     */
    public synchronized void add(Person person) throws IOException {
        List<Person> people = new ArrayList<>(all());
        if (people.stream().anyMatch(one -> one.name().equals(person.name()))) {
            throw new IllegalArgumentException(
                    person.name() + " is listed already; 'crw people role' changes the role");
        }
        people.add(person);
        write(people);
    }

    /**
     * Removes somebody, who is out of running sessions within a second.
     *
     * @throws IllegalArgumentException in words, if there is nobody of that name
     * @throws IOException if the file cannot be read or written
     */
    public synchronized void remove(String name) throws IOException {
        List<Person> people = new ArrayList<>(all());
        if (!people.removeIf(one -> one.name().equals(name))) {
            throw nobody(name);
        }
        write(people);
    }

    /**
     * Gives somebody another role and other decisions; the key stays. Running sessions follow within a second.
     *
     * @param decisions the types of decisions that are theirs; empty for those of the role
     * @return the person before
     * @throws IllegalArgumentException in words, if there is nobody of that name
     * @throws IOException if the file cannot be read or written
     */
    public synchronized Person change(String name, PersonRole role, List<String> decisions) throws IOException {
        List<Person> people = new ArrayList<>(all());
        for (int i = 0; i < people.size(); i++) {
            Person before = people.get(i);
            if (before.name().equals(name)) {
                people.set(i, new Person(name, role, decisions, before.keyHash()));
                write(people);
                return before;
            }
        }
        throw nobody(name);
    }

    private static IllegalArgumentException nobody(String name) {
        return new IllegalArgumentException("nobody here is named '" + name + "'");
    }

    private void write(List<Person> people) throws IOException {
        ObjectNode root = JSON.createObjectNode().put("version", VERSION);
        ArrayNode list = root.putArray("people");
        for (Person person : people) {
            ObjectNode one = list.addObject()
                    .put("name", person.name())
                    .put("role", person.role().word())
                    .put("key", person.keyHash());
            ArrayNode decisions = one.putArray("decisions");
            person.decisions().forEach(decisions::add);
        }
        OwnerOnlyFile.write(file, JSON.writerWithDefaultPrettyPrinter().writeValueAsBytes(root));
    }

    private List<Person> readable() {
        try {
            return all();
        } catch (IOException damaged) {
            return List.of(); // nobody is let in by a list that cannot be read
        }
    }

    @Override
    public Optional<Person> login(String name, String key) {
        return readable().stream()
                .filter(one -> one.name().equals(name) && PersonKey.matches(key, one.keyHash()))
                .findFirst();
    }

    /** The person as before while the list cannot be read: nobody is sent away by a damaged file. */
    @Override
    public Optional<Person> present(Person earlier) {
        List<Person> now;
        try {
            now = all();
        } catch (IOException damaged) {
            return Optional.of(earlier);
        }
        return now.stream()
                .filter(one ->
                        one.name().equals(earlier.name()) && one.keyHash().equals(earlier.keyHash()))
                .findFirst();
    }

    @Override
    public Optional<String> fault() {
        try {
            all();
            return Optional.empty();
        } catch (IOException damaged) {
            return Optional.of(String.valueOf(damaged.getMessage()));
        }
    }

    @Override
    public boolean needKeys() {
        return true;
    }
}
