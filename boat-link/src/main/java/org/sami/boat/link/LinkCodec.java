package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.StreamReadConstraints;
import com.fasterxml.jackson.core.StreamReadFeature;
import com.fasterxml.jackson.core.StreamWriteFeature;
import com.fasterxml.jackson.core.json.JsonReadFeature;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.ObjectReader;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.CodingErrorAction;
import java.nio.charset.StandardCharsets;
import org.sami.boat.link.Checks.BadValueException;
import org.sami.boat.link.LinkException.Fault;

/**
 * Writes messages as frames and reads frames as messages; see the package for the layout of a frame.
 *
 * <p>Reading trusts nothing: lengths, nesting and texts are bounded before anything is kept, UTF-8 is strict, numbers are
 * finite and in range, and whatever is wrong is a {@link LinkException} that says what and where. It does not check who
 * sent a frame, nor in which order.
 *
 * <p>Safe for use by several threads.
 */
public final class LinkCodec {
    /**
     * The version byte of the frames that this codec writes, and the only one that it reads. Version 1 had no check
     * value and no terms.
     */
    public static final int VERSION = 2;

    /** The length field in front of a frame. */
    public static final int LENGTH_BYTES = 4;

    /** The largest frame that is taken unless another bound is given, in bytes without the length field. */
    public static final int DEFAULT_MAX_BYTES = 4 << 20;

    /** Where the check value of a frame begins. */
    static final int CHECK_AT = LENGTH_BYTES + 1;

    /** What stands before the body: length, version and check value. */
    public static final int HEADER_BYTES = CHECK_AT + 4;

    private static final JsonFactory FACTORY = JsonFactory.builder()
            .streamReadConstraints(StreamReadConstraints.builder()
                    .maxNestingDepth(8)
                    .maxStringLength(8 * Checks.MAX_TEXT_LENGTH)
                    .maxNameLength(Checks.MAX_ID_LENGTH)
                    .maxNumberLength(64)
                    .build())
            .enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION)
            .enable(StreamReadFeature.USE_FAST_DOUBLE_PARSER)
            .enable(StreamWriteFeature.USE_FAST_DOUBLE_WRITER)
            .enable(JsonReadFeature.ALLOW_NON_NUMERIC_NUMBERS) // so that a NaN is refused by its name, with its command
            .disable(JsonFactory.Feature.INTERN_FIELD_NAMES)
            .build();
    private static final ObjectReader TREES = new ObjectMapper(FACTORY)
            .reader()
            .with(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
            .forType(JsonNode.class);

    /** The codec with the default bound on frames. */
    public static final LinkCodec STANDARD = new LinkCodec();

    private final int maxBytes;

    /** A codec with the default bound on frames. */
    public LinkCodec() {
        this(DEFAULT_MAX_BYTES);
    }

    /** A codec that neither makes nor takes frames above a bound, in bytes without the length field. */
    public LinkCodec(int maxBytes) {
        if (maxBytes < 64) {
            throw new IllegalArgumentException("no message fits into " + maxBytes + " bytes");
        }
        this.maxBytes = maxBytes;
    }

    /** The largest frame that is made or taken, in bytes without the length field. */
    public int maxBytes() {
        return maxBytes;
    }

    /**
     * Writes a message of no term as a whole frame, with its length and check value.
     *
     * @throws IllegalArgumentException if the frame would be larger than this codec takes
     */
    public byte[] encode(long sequence, LinkMessage message) {
        return encode(new Frame(sequence, "", message));
    }

    /**
     * Writes a frame, with its length and check value.
     *
     * @throws IllegalArgumentException if the frame would be larger than this codec takes
     */
    public byte[] encode(Frame frame) {
        LinkMessage message = frame.message();
        FrameBuffer buffer = new FrameBuffer();
        write(frame, buffer);
        if (buffer.size() - LENGTH_BYTES > maxBytes) {
            throw new IllegalArgumentException(
                    "a " + message.type() + " of " + buffer.size() + " bytes; the link takes " + maxBytes);
        }
        return buffer.toFrame();
    }

    /** Writes a message as the body of a frame, for logs. */
    public static byte[] body(LinkMessage message) {
        ByteArrayOutputStream buffer = new ByteArrayOutputStream();
        write(new Frame(0, "", message), buffer);
        return buffer.toByteArray();
    }

    private static void write(Frame frame, OutputStream to) {
        try (JsonGenerator out = FACTORY.createGenerator(to)) {
            out.writeStartObject();
            out.writeStringField("type", frame.message().type());
            out.writeNumberField("seq", frame.sequence());
            if (!frame.term().isEmpty()) {
                out.writeStringField("term", frame.term());
            }
            frame.message().write(out);
            out.writeEndObject();
        } catch (IOException e) {
            throw new UncheckedIOException("writing to memory failed", e);
        }
    }

    /**
     * Reads the body of a frame, as {@link #body} gives it, from a log.
     *
     * @throws LinkException if it is not exactly one well-formed message
     */
    public static LinkMessage readBody(byte[] body) throws LinkException {
        checkEncoding(body, 0);
        return message(parse(body, 0)).message();
    }

    /**
     * The version that a peer speaks, by a whole frame of it; whether the rest can be read is another question. The length is the
     * same in all versions.
     */
    public static int versionOf(byte[] frame) {
        return frame.length > LENGTH_BYTES ? frame[LENGTH_BYTES] & 0xff : VERSION;
    }

    /**
     * Reads one whole frame, as {@link #encode} or {@link FrameReader#next} gives it.
     *
     * @throws LinkException if the frame is not exactly one well-formed message
     */
    public Frame decode(byte[] frame) throws LinkException {
        if (frame.length <= LENGTH_BYTES) {
            throw new LinkException(Fault.TRUNCATED, "", frame.length + " bytes are no frame");
        }
        checkLength(ByteBuffer.wrap(frame).getInt(), frame.length - LENGTH_BYTES);
        if (versionOf(frame) != VERSION) {
            throw new LinkException(
                    Fault.VERSION,
                    "",
                    "this is link version " + versionOf(frame) + "; version " + VERSION + " is read here");
        }
        if (frame.length < HEADER_BYTES) {
            throw new LinkException(Fault.TRUNCATED, "", frame.length + " bytes are no frame");
        }
        if (ByteBuffer.wrap(frame).getInt(CHECK_AT) != FrameCheck.of(frame)) {
            throw new LinkException(Fault.CHECK, "", "damaged on its way: the check value does not fit");
        }
        checkEncoding(frame, HEADER_BYTES);
        return message(parse(frame, HEADER_BYTES));
    }

    private void checkLength(int declared, int there) throws LinkException {
        checkDeclared(declared, maxBytes);
        if (declared != there) {
            Fault fault = declared > there ? Fault.TRUNCATED : Fault.LENGTH;
            throw new LinkException(fault, "", declared + " bytes declared, " + there + " there");
        }
    }

    static void checkDeclared(int declared, int maxBytes) throws LinkException {
        if (declared < 1 || declared > maxBytes) {
            throw new LinkException(Fault.LENGTH, "", "declared length " + declared + " is not in 1 to " + maxBytes);
        }
    }

    /** Strict UTF-8 without NUL, so that the parser never takes the body for another encoding. */
    private static void checkEncoding(byte[] frame, int from) throws LinkException {
        boolean ascii = true;
        for (int i = from; i < frame.length; i++) {
            if (frame[i] == 0) {
                throw new LinkException(Fault.ENCODING, "", "NUL at byte " + i);
            }
            ascii &= frame[i] > 0;
        }
        if (ascii) {
            return;
        }
        try {
            StandardCharsets.UTF_8
                    .newDecoder()
                    .onMalformedInput(CodingErrorAction.REPORT)
                    .onUnmappableCharacter(CodingErrorAction.REPORT)
                    .decode(ByteBuffer.wrap(frame, from, frame.length - from));
        } catch (CharacterCodingException e) {
            throw new LinkException(Fault.ENCODING, "", "not UTF-8");
        }
    }

    private static JsonNode parse(byte[] frame, int from) throws LinkException {
        JsonNode body;
        try (JsonParser parser = FACTORY.createParser(frame, from, frame.length - from)) {
            body = TREES.readTree(parser);
            if (parser.nextToken() != null) {
                throw new LinkException(Fault.SYNTAX, "", "something follows the object");
            }
        } catch (JsonProcessingException e) {
            throw new LinkException(Fault.SYNTAX, "", e.getOriginalMessage());
        } catch (IOException e) {
            throw new LinkException(Fault.SYNTAX, "", String.valueOf(e.getMessage()));
        }
        if (body == null || !body.isObject()) {
            throw new LinkException(Fault.SYNTAX, "", "the body is no object");
        }
        return body;
    }

    private static Frame message(JsonNode body) throws LinkException {
        Fields fields = new Fields(body);
        try {
            LinkMessage message = MessageReaders.read(fields.text("type"), fields);
            return new Frame(fields.integer("seq"), fields.textOrEmpty("term"), message);
        } catch (BadValueException e) {
            throw Fields.fault(e).ofCommand(commandIdOf(body));
        } catch (LinkException e) {
            throw e.ofCommand(commandIdOf(body));
        }
    }

    private static String commandIdOf(JsonNode body) {
        JsonNode id = body.get("command");
        boolean readable = id != null && id.isTextual() && id.textValue().length() <= Checks.MAX_ID_LENGTH;
        return readable ? id.textValue() : "";
    }
}
