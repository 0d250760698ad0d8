package org.sami.lessons.course;

import com.fasterxml.jackson.annotation.JsonProperty;
import com.fasterxml.jackson.annotation.JsonSubTypes;
import com.fasterxml.jackson.annotation.JsonTypeInfo;
import com.fasterxml.jackson.databind.JsonNode;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/** A step of a lesson: a page that a learner reads, looks at, or does something on. */
@JsonTypeInfo(use = JsonTypeInfo.Id.NAME, property = "kind")
@JsonSubTypes({
    @JsonSubTypes.Type(value = Step.Text.class, name = "text"),
    @JsonSubTypes.Type(value = Step.Show.class, name = "show"),
    @JsonSubTypes.Type(value = Step.Play.class, name = "play"),
    @JsonSubTypes.Type(value = Step.Quiz.class, name = "quiz"),
    @JsonSubTypes.Type(value = Step.Job.class, name = "job")
})
public sealed interface Step {
    /** In kebab case; unique in its lesson. */
    String id();

    /** What stands above it. */
    String title();

    /** Its paragraphs, as {@link Paragraph} reads them. */
    List<String> text();

    /** The picture that goes with it. */
    Optional<Picture> picture();

    /** A text, maybe with a picture. */
    record Text(
            @JsonProperty(required = true) String id,
            @JsonProperty(required = true) String title,
            @JsonProperty(required = true) List<String> text,
            Optional<Picture> picture)
            implements Step {
        public Text {
            Objects.requireNonNull(id, "id");
            Objects.requireNonNull(title, "title");
            text = List.copyOf(text);
            Objects.requireNonNull(picture, "picture");
        }
    }

    /**
     * Edits that are played in the editor.
     *
     * @param plan the project that they begin with: {@link Course#project}
     * @param script the edits, as {@code org.sami.lessons.script} reads them
     * @param result the project that they lead to, but for positions and ids
     */
    record Show(
            @JsonProperty(required = true) String id,
            @JsonProperty(required = true) String title,
            @JsonProperty(required = true) List<String> text,
            Optional<Picture> picture,
            @JsonProperty(required = true) String plan,
            @JsonProperty(required = true) List<JsonNode> script,
            Optional<String> result)
            implements Step {
        public Show {
            Objects.requireNonNull(id, "id");
            Objects.requireNonNull(title, "title");
            text = List.copyOf(text);
            Objects.requireNonNull(picture, "picture");
            Objects.requireNonNull(plan, "plan");
            script = List.copyOf(script);
            Objects.requireNonNull(result, "result");
        }
    }

    /**
     * A net that runs on the engine.
     *
     * @param plan which: {@link Course#plan}
     * @param testCase the test case of that plan that is played; without it the learner plays freely
     * @param robots who is there where the learner plays freely
     */
    record Play(
            @JsonProperty(required = true) String id,
            @JsonProperty(required = true) String title,
            @JsonProperty(required = true) List<String> text,
            Optional<Picture> picture,
            @JsonProperty(required = true) String plan,
            @JsonProperty("case") Optional<String> testCase,
            List<String> robots)
            implements Step {
        public Play {
            Objects.requireNonNull(id, "id");
            Objects.requireNonNull(title, "title");
            text = List.copyOf(text);
            Objects.requireNonNull(picture, "picture");
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(testCase, "testCase");
            robots = Absent.orNone(robots);
        }
    }

    /**
     * A question.
     *
     * @param review whether it repeats an earlier lesson
     * @param ask what is asked
     * @param explained the step that explained it: {@link Course#address}
     * @param solved what is so, in one or two sentences
     * @param play the test case of the picture's plan that shows the right answer
     */
    record Quiz(
            @JsonProperty(required = true) String id,
            @JsonProperty(required = true) String title,
            @JsonProperty(required = true) List<String> text,
            Optional<Picture> picture,
            boolean review,
            @JsonProperty(required = true) QuizQuestion ask,
            @JsonProperty(required = true) String explained,
            @JsonProperty(required = true) String solved,
            Optional<String> play)
            implements Step {
        public Quiz {
            Objects.requireNonNull(id, "id");
            Objects.requireNonNull(title, "title");
            text = List.copyOf(text);
            Objects.requireNonNull(picture, "picture");
            Objects.requireNonNull(ask, "ask");
            Objects.requireNonNull(explained, "explained");
            Objects.requireNonNull(solved, "solved");
            Objects.requireNonNull(play, "play");
        }
    }

    /**
     * A plan that the learner makes or changes in the editor.
     *
     * @param job the name of its file: {@link Course#jobs}
     */
    record Job(
            @JsonProperty(required = true) String id,
            @JsonProperty(required = true) String title,
            @JsonProperty(required = true) List<String> text,
            Optional<Picture> picture,
            @JsonProperty(required = true) String job)
            implements Step {
        public Job {
            Objects.requireNonNull(id, "id");
            Objects.requireNonNull(title, "title");
            text = List.copyOf(text);
            Objects.requireNonNull(picture, "picture");
            Objects.requireNonNull(job, "job");
        }
    }
}
